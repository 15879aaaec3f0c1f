// The machine from its side or from above: the last good picture, with handles on what the deck places. The engine
// gives all shapes in metres; here they are only scaled to the screen.
import { el } from './dom';
import type { Handle, Page, Scene } from './types';
import { tensionColour } from './colour';
import { type Second, dragged, largestForce, movable, placed, spoken, stepped, tip, valuesOf, written } from './handles';

export type View = 'side' | 'plan';

interface Fit {
  scale: number;
  left: number;
  top: number;
}

/** A drag: the handle and its numbers, in SI. */
export type Moved = (handle: Handle, values: number[], done: boolean) => void;

/** Length of the longest arrow, px: as wide as the margin, so that its end is in the picture. */
const longestArrow = 42;

interface Drag {
  handle: Handle;
  from: number[];
  values: number[];
  right: number;
  up: number;
  dot: HTMLElement;
  fit: Fit;
  /** Where it was taken, and how far its arrow reached: the text follows the drag and changes the handle. */
  taken: Handle;
}

export class Drawing {
  readonly canvas = el('canvas', { 'aria-hidden': 'true' });
  readonly layer = el('div', { class: 'handles' });
  private page: Page | null = null;
  private scene: Scene | null = null;
  private all: Handle[] = [];
  private handles: Handle[] = [];
  private newtons = 0;
  private fit: Fit = { scale: 1, left: 0, top: 0 };
  private view: View = 'side';
  private frame = 0;
  private drag: Drag | null = null;
  private asked = 0;

  constructor(private box: HTMLElement, private moved: Moved, private chosen: (handle: Handle) => void) {
    box.append(this.canvas, this.layer);
    new ResizeObserver(() => this.draw()).observe(box);
  }

  show(page: Page | null, scene: Scene | null): void {
    this.page = page;
    this.scene = scene;
    this.frame = Math.min(this.frame, (scene?.t.length ?? 1) - 1);
    this.draw();
  }

  /** Handles of the deck whose picture is shown. */
  place(handles: Handle[]): void {
    this.all = handles;
    this.layer.hidden = false;
    this.find();
  }

  /** The text has changed, and these handles are left; null: none can be moved until the next picture, loads stay. */
  keep(left: Handle[] | null): void {
    this.layer.hidden = left === null;
    if (left) this.all = left;
    if (left) this.handles = this.handles.filter((h) => left.includes(h));
    if (this.drag && !left?.includes(this.drag.handle)) this.drag = null;
    this.draw();
  }

  setFrame(frame: number): void {
    this.frame = frame;
    if (!this.drag) this.find();
  }

  setView(view: View): void {
    this.view = view;
    this.find();
  }

  private find(): void {
    this.handles = placed(this.all, this.scene, this.frame).filter((h) => movable(h, this.second));
    if (this.drag) {
      const same = this.handles.find((h) => h.path === this.drag?.handle.path);
      this.drag = same ? { ...this.drag, handle: same } : null;
    }
    const largest = largestForce(this.handles);
    // a load that grows in a drag does not shrink again when it is let go
    if (!this.drag && (largest > 1.5 * this.newtons || largest < 0.3 * this.newtons)) this.newtons = largest;
    this.draw();
  }

  private get second(): Second {
    return this.view === 'side' ? 2 : 1;
  }

  /** Metres of the drawing for a newton. */
  private get arrows(): number {
    return this.newtons > 0 ? (this.box.clientWidth < 500 ? 0.65 : 1) * longestArrow / (this.newtons * this.fit.scale) : 0;
  }

  /** Once for each picture of the screen, however often it is asked for. */
  draw(): void {
    if (this.asked) return;
    this.asked = requestAnimationFrame(() => {
      this.asked = 0;
      this.paint();
    });
  }

  private up(at: readonly (number | null)[]): number {
    return (this.view === 'side' ? at[2] : at[1]) ?? 0;
  }

  private pixel(x: number, up: number): [number, number] {
    return [this.fit.left + x * this.fit.scale, this.fit.top - up * this.fit.scale];
  }

  private fitted(width: number, height: number): Fit {
    let low = [Infinity, Infinity];
    let high = [-Infinity, -Infinity];
    const add = (x: number | null | undefined, up: number | null | undefined) => {
      if (x == null || up == null) return;
      low = [Math.min(low[0]!, x), Math.min(low[1]!, up)];
      high = [Math.max(high[0]!, x), Math.max(high[1]!, up)];
    };
    const second = this.view === 'side' ? 2 : 1;
    for (const line of this.scene?.lines ?? []) {
      for (const frame of line.points) for (let i = 0; i < frame.length; i += 3) add(frame[i], frame[i + second]);
    }
    for (const p of this.scene?.points ?? []) for (const at of p.at) add(at[0], at[second]);
    for (const h of this.handles) add(h.at[0], this.up(h.at));
    if (this.view === 'side') {
      const ground = this.page?.ground ?? [];
      for (let i = 0; i < ground.length; i += 2) add(ground[i], ground[i + 1]);
    }
    if (!Number.isFinite(low[0])) return { scale: 1, left: 0, top: 0 };
    const margin = width < 500 ? 30 : 46;
    const wide = Math.max(high[0]! - low[0]!, 0.01);
    const tall = Math.max(high[1]! - low[1]!, 0.01);
    const scale = Math.max(Math.min((width - 2 * margin) / wide, (height - 2 * margin) / tall), 1e-9);
    return {
      scale,
      left: width / 2 - (scale * (low[0]! + high[0]!)) / 2,
      top: height / 2 + (scale * (low[1]! + high[1]!)) / 2,
    };
  }

  private paint(): void {
    const width = this.box.clientWidth;
    const height = this.box.clientHeight;
    if (width === 0 || height === 0) return;
    const ratio = window.devicePixelRatio || 1;
    if (this.canvas.width !== Math.round(width * ratio) || this.canvas.height !== Math.round(height * ratio)) {
      this.canvas.width = Math.round(width * ratio);
      this.canvas.height = Math.round(height * ratio);
    }
    const g = this.canvas.getContext('2d');
    if (!g) return;
    g.setTransform(ratio, 0, 0, ratio, 0, 0);
    g.clearRect(0, 0, width, height);
    this.fit = this.drag ? this.drag.fit : this.fitted(width, height);
    const style = getComputedStyle(this.box);
    const colour = (name: string) => style.getPropertyValue(`--${name}`).trim();
    g.font = '11.5px system-ui, sans-serif';
    this.paintRuler(g, width, height, colour);
    this.paintGround(g, height, colour);
    this.paintLines(g, colour);
    this.paintPoints(g, colour);
    this.paintArrows(g, colour);
    if (this.drag) this.paintDrag(g, colour);
    this.placeDots();
  }

  private paintRuler(g: CanvasRenderingContext2D, width: number, height: number, colour: (name: string) => string): void {
    const wanted = 90 / this.fit.scale;
    const power = 10 ** Math.floor(Math.log10(wanted));
    const step = [1, 2, 5, 10].map((k) => k * power).find((k) => k >= wanted) ?? wanted;
    const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
    g.lineWidth = 1;
    g.strokeStyle = colour('grid');
    g.fillStyle = colour('faint');
    const first = Math.ceil(-this.fit.left / this.fit.scale / step);
    for (let k = first; ; ++k) {
      const [x] = this.pixel(k * step, 0);
      if (x > width) break;
      g.beginPath();
      g.moveTo(Math.round(x) + 0.5, 0);
      g.lineTo(Math.round(x) + 0.5, height);
      g.stroke();
      if (x < width - 40) g.fillText(`${(k * step).toFixed(decimals)} m`, x + 3, height - 5);
    }
    const low = Math.ceil((this.fit.top - height) / this.fit.scale / step);
    for (let k = low; ; ++k) {
      const [, y] = this.pixel(0, k * step);
      if (y < 0) break;
      g.beginPath();
      g.moveTo(0, Math.round(y) + 0.5);
      g.lineTo(width, Math.round(y) + 0.5);
      g.stroke();
      if (y > 14 && y < height - 20) g.fillText(`${(k * step).toFixed(decimals)} m`, 4, y - 3);
    }
  }

  private paintGround(g: CanvasRenderingContext2D, height: number, colour: (name: string) => string): void {
    const ground = this.page?.ground ?? [];
    if (this.view !== 'side' || ground.length < 4) return;
    g.beginPath();
    let first = 0;
    let last = 0;
    for (let i = 0; i < ground.length; i += 2) {
      const [x, y] = this.pixel(ground[i] ?? 0, ground[i + 1] ?? 0);
      if (i === 0) g.moveTo((first = x), y);
      else g.lineTo(x, y);
      last = x;
    }
    g.strokeStyle = colour('ground');
    g.lineWidth = 1.5;
    g.stroke();
    g.lineTo(last, height);
    g.lineTo(first, height);
    g.closePath();
    g.fillStyle = colour('ground-area');
    g.fill();
  }

  private paintLines(g: CanvasRenderingContext2D, colour: (name: string) => string): void {
    const range = this.scene?.tension ?? null;
    const second = this.view === 'side' ? 2 : 1;
    g.lineCap = 'round';
    for (const line of this.scene?.lines ?? []) {
      const points = line.points[Math.min(this.frame, line.points.length - 1)] ?? [];
      const tension = line.tension[Math.min(this.frame, line.tension.length - 1)] ?? [];
      const isRope = tension.length > 0;
      g.lineWidth = isRope ? 2.6 : 2;
      for (let i = 0; i + 5 < points.length; i += 3) {
        const a = [points[i], points[i + second], points[i + 3], points[i + 3 + second]];
        if (a.some((v) => v == null)) continue;
        const here = tension[i / 3];
        g.strokeStyle = isRope && range && here != null ? tensionColour(here, range.least, range.most) : colour('structure');
        g.beginPath();
        g.moveTo(...this.pixel(a[0]!, a[1]!));
        g.lineTo(...this.pixel(a[2]!, a[3]!));
        g.stroke();
      }
    }
  }

  private paintPoints(g: CanvasRenderingContext2D, colour: (name: string) => string): void {
    const taken: [number, number, number, number][] = [];
    const named = new Set<string>();
    for (const p of this.scene?.points ?? []) {
      const at = p.at[Math.min(this.frame, p.at.length - 1)];
      if (!at || at.some((v) => v == null)) continue;
      const [x, y] = this.pixel(at[0], this.up(at));
      const radius = Math.max(p.radius * this.fit.scale, 3);
      g.beginPath();
      g.arc(x, y, radius, 0, 2 * Math.PI);
      g.fillStyle = colour('body-area');
      g.fill();
      g.lineWidth = 1.5;
      g.strokeStyle = colour('structure');
      g.stroke();
      if (named.has(p.name)) continue;
      named.add(p.name);
      const wide = g.measureText(p.name).width;
      const places = [[x + radius + 6, y - 7], [x - radius - 6 - wide, y - 7], [x - wide / 2, y - radius - 9],
        [x - wide / 2, y + radius + 16], [x + radius + 6, y + 14], [x - radius - 6 - wide, y + 14]];
      const box = places
        .map(([left, base]) => [left!, base! - 10, left! + wide, base! + 3] as [number, number, number, number])
        .find((b) => b[0] >= 2 && b[2] <= this.box.clientWidth - 2 &&
          !taken.some((t) => b[0] < t[2] && t[0] < b[2] && b[1] < t[3] && t[1] < b[3]));
      if (!box) continue;
      taken.push(box);
      g.lineWidth = 3;
      g.strokeStyle = colour('paper');
      g.strokeText(p.name, box[0], box[3] - 3);
      g.fillStyle = colour('ink');
      g.fillText(p.name, box[0], box[3] - 3);
    }
  }

  private where(h: Handle): [number, number] {
    const at = this.drag?.handle === h ? tip(this.drag.taken, this.drag.values, this.arrows) : tip(h, valuesOf(h), this.arrows);
    return this.pixel(at[0], this.up(at));
  }

  private paintArrows(g: CanvasRenderingContext2D, colour: (name: string) => string): void {
    g.strokeStyle = colour('force');
    g.fillStyle = colour('force');
    g.lineWidth = 2;
    for (const h of this.handles) {
      if (h.kind !== 'load') continue;
      const from = this.pixel(h.at[0], this.up(h.at));
      const to = this.where(h);
      g.beginPath();
      g.moveTo(...from);
      g.lineTo(...to);
      g.stroke();
    }
  }

  private paintDrag(g: CanvasRenderingContext2D, colour: (name: string) => string): void {
    if (!this.drag) return;
    const { handle, taken, from, values } = this.drag;
    const start = tip(taken, from, this.arrows);
    const to = this.where(handle);
    g.setLineDash([4, 4]);
    g.lineWidth = 1.5;
    g.strokeStyle = colour('accent');
    g.beginPath();
    g.moveTo(...this.pixel(start[0], this.up(start)));
    g.lineTo(...to);
    g.stroke();
    g.setLineDash([]);
    const words = handle.numbers.map((n, i) => written(values[i]!, n)).join(', ');
    g.fillStyle = colour('ink');
    g.fillText(words, to[0] + 12, to[1] - 14);
  }

  private placeDots(): void {
    const dots = [...this.layer.children] as HTMLElement[];
    const unused = new Map(dots.map((dot) => [dot.dataset.path, dot]));
    this.handles.forEach((handle) => {
      let dot = unused.get(handle.path);
      unused.delete(handle.path);
      if (!dot) {
        dot = el('button', { class: 'handle', type: 'button', 'data-path': handle.path });
        this.listen(dot);
        this.layer.append(dot);
      }
      const values = this.drag?.dot === dot ? this.drag.values : valuesOf(handle);
      dot.dataset.kind = handle.kind;
      dot.setAttribute('aria-label', spoken(handle, values));
      dot.title = spoken(handle, values).replace(/; arrow keys.*/, '');
      const [x, y] = this.where(handle);
      dot.style.transform = `translate(${x}px, ${y}px)`;
    });
    for (const dot of unused.values()) dot.remove();
  }

  private listen(dot: HTMLElement): void {
    const handle = () => this.handles.find((h) => h.path === dot.dataset.path);
    dot.addEventListener('focus', () => {
      const h = handle();
      if (h) this.chosen(h);
    });
    dot.addEventListener('pointerdown', (event) => {
      const h = handle();
      if (!h || event.button !== 0) return;
      dot.setPointerCapture(event.pointerId);
      dot.focus();
      const taken = { ...h, at: [...h.at] as Handle['at'], numbers: h.numbers.map((n) => ({ ...n })) };
      this.drag = { handle: h, taken, from: valuesOf(h), values: valuesOf(h), right: event.clientX, up: event.clientY, dot, fit: this.fit };
      event.preventDefault();
    });
    dot.addEventListener('pointermove', (event) => {
      if (!this.drag || this.drag.dot !== dot) return;
      const d = this.drag;
      d.values = dragged(d.taken, d.from, (event.clientX - d.right) / d.fit.scale, (d.up - event.clientY) / d.fit.scale,
        this.second, this.arrows, d.fit.scale);
      this.moved(d.handle, d.values, false);
      this.draw();
    });
    const end = (event: PointerEvent) => {
      if (!this.drag || this.drag.dot !== dot) return;
      const { handle: h, from, values } = this.drag;
      this.drag = null;
      this.moved(h, event.type === 'pointercancel' ? from : values, true);
      this.draw();
    };
    dot.addEventListener('pointerup', end);
    dot.addEventListener('pointercancel', end);
    dot.addEventListener('keydown', (event) => {
      const h = handle();
      const steps: Record<string, [number, number]> = {
        ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1],
      };
      const step = steps[event.key];
      if (!h || !step) return;
      event.preventDefault();
      this.moved(h, stepped(h, step[0], step[1], event.shiftKey ? 10 : 1, this.second, this.arrows, this.fit.scale), true);
    });
  }
}
