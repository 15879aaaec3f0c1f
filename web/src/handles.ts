// What the drawing can drag: from the numbers of the deck to a place in the drawing, and back. The engine says what one
// unit of a number moves (`along`); here that is only scaled to the screen.
import type { Handle, HandleNumber, Scene } from './types';

export type Place = [number, number, number];

/** The two directions of the drawing: x, and z from the side or y from above. */
export type Second = 1 | 2;

const isArrow = (h: Handle) => h.kind === 'load';
const dot = (a: readonly number[], b: readonly number[]) => a.reduce((sum, v, i) => sum + v * b[i]!, 0);

export function valuesOf(h: Handle): number[] {
  return h.numbers.map((n) => n.value);
}

/** Metres by which the numbers move a place; of an arrow newtons. */
function span(h: Handle, values: readonly number[]): Place {
  return [0, 1, 2].map((k) => h.numbers.reduce((sum, n, i) => sum + n.along[k]! * values[i]!, 0)) as Place;
}

/** The handles that the drawing can show: those on a part of the result get its place at that time. */
export function placed(all: Handle[], scene: Scene | null, frame: number): Handle[] {
  return all.filter((h) => {
    if (h.on === undefined) return true;
    const point = scene?.points.find((p) => p.name === h.on);
    const at = point?.at[Math.min(frame, point.at.length - 1)];
    if (!at || at.some((v) => v == null)) return false;
    // a picture of another state (a motion, or an equilibrium before) has the carriage elsewhere: there is nothing to drag
    if (!isArrow(h) && h.numbers.some((n) => Math.abs(dot(n.along, at) - n.value) > 1e-3 * Math.max(1, Math.abs(n.value)))) return false;
    h.at = [...at];
    return true;
  });
}

/** Newtons of the longest arrow. */
export function largestForce(all: Handle[]): number {
  return Math.max(0, ...all.filter(isArrow).map((h) => Math.hypot(...span(h, valuesOf(h)))));
}

/** Where the handle stands when its numbers are `values`; arrows have `arrows` metres for a newton. */
export function tip(h: Handle, values: readonly number[], arrows: number): Place {
  const moved = isArrow(h) ? span(h, values) : span(h, values.map((v, i) => v - h.numbers[i]!.value));
  const scale = isArrow(h) ? arrows : 1;
  return h.at.map((v, k) => v + scale * moved[k]!) as Place;
}

/** What one SI unit of a number moves in the drawing, m to the right and up. */
function inDrawing(h: Handle, n: HandleNumber, second: Second, arrows: number): [number, number] {
  const scale = isArrow(h) ? arrows : 1;
  return [scale * n.along[0], scale * n.along[second]];
}

/** Whether the drawing shows a move of one of its numbers at all: from above no weight does. */
export function movable(h: Handle, second: Second): boolean {
  return h.numbers.some((n) => Math.hypot(n.along[0], n.along[second]) > 1e-6 * Math.hypot(...n.along));
}

/** A round number of the deck's unit, of about a pixel and a half, not finer than the deck's own digits. */
function step(n: HandleNumber, pixels: number): number {
  const own = 10 ** -Math.max(n.decimals, 1);
  return Math.max(10 ** Math.ceil(Math.log10(1.5 / (pixels * n.factor))), own);
}

function rounded(n: HandleNumber, value: number, pixels: number): number {
  const size = step(n, pixels);
  return Math.max(Math.round(value / n.factor / size) * size * n.factor, n.least ?? -Infinity);
}

/** The numbers after the pointer has moved by `right` and `up` metres of the drawing. `scale`: pixels of a metre. */
export function dragged(h: Handle, from: readonly number[], right: number, up: number, second: Second, arrows: number, scale: number): number[] {
  return h.numbers.map((n, i) => {
    const [x, y] = inDrawing(h, n, second, arrows);
    const square = x * x + y * y;
    const change = square > 0 ? (right * x + up * y) / square : 0;
    return change === 0 ? from[i]! : rounded(n, from[i]! + change, scale * Math.sqrt(square));
  });
}

/** The numbers after an arrow key: one step of those that move along it. */
export function stepped(h: Handle, right: number, up: number, times: number, second: Second, arrows: number, scale: number): number[] {
  return h.numbers.map((n) => {
    const [x, y] = inDrawing(h, n, second, arrows);
    const long = Math.hypot(x, y);
    const share = long > 0 ? (right * x + up * y) / long : 0;
    if (Math.abs(share) < 0.5) return n.value;
    return rounded(n, n.value + Math.sign(share) * times * step(n, scale * long) * n.factor, scale * long);
  });
}

/** The numbers of the deck are these now. */
export function take(h: Handle, values: readonly number[]): void {
  if (!isArrow(h)) h.at = tip(h, values, 1);
  h.numbers.forEach((n, i) => { n.value = values[i]!; });
}

export function spoken(h: Handle, values: readonly number[]): string {
  const numbers = h.numbers.map((n, i) => written(values[i]!, n)).join(', ');
  if (isArrow(h)) return `load on ${h.name}, ${numbers}; arrow keys change it`;
  if (h.kind === 'carriage') return `place of carriage ${h.name}, ${numbers}; arrow keys move it`;
  if (h.kind === 'guess') return `first guess of the place of ${h.name}, ${numbers}; arrow keys move it`;
  return `${h.kind} ${h.name}, at ${numbers}; arrow keys move it`;
}

/** A number as it is written into the deck, in the unit that stands there. */
export function written(value: number, n: HandleNumber): string {
  const text = (value / n.factor).toFixed(Math.max(n.decimals, 3));
  const [whole, fraction = ''] = text.split('.');
  let digits = fraction;
  while (digits.length > n.decimals && digits.endsWith('0')) digits = digits.slice(0, -1);
  const number = digits ? `${whole}.${digits}` : `${whole}`;
  return `${Number(number) === 0 ? number.replace('-', '') : number} ${n.unit}`;
}
