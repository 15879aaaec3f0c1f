// Curves of the result, as the engine gives them, in the units of the report.
import uPlot from 'uplot';
import { el } from './dom';
import type { Curve, PlotData } from './types';

const pens = ['rope', 'highlight', 'second-rope', 'force', 'second-force', 'body', 'ground', 'structure'];

/** Curves over one common axis, as uPlot takes no other for its scales and its cursor. It has an x as often as one
    curve has points there, at a jump or where it runs back: none is lost. */
function joined(plot: PlotData): (number | null)[][] {
  const places = (c: Curve) => {
    const seen = new Map<number, number>();
    return c.x.map((x) => {
      if (x == null) return null;
      const k = seen.get(x) ?? 0;
      seen.set(x, k + 1);
      return { x, k };
    });
  };
  const most = new Map<number, number>();
  for (const c of plot.curves) {
    for (const at of places(c)) if (at) most.set(at.x, Math.max(most.get(at.x) ?? 0, at.k + 1));
  }
  const first = new Map<number, number>();
  const all: number[] = [];
  for (const x of [...most.keys()].sort((a, b) => a - b)) {
    first.set(x, all.length);
    for (let k = most.get(x)!; k > 0; --k) all.push(x);
  }
  const rows = plot.curves.map((c) => {
    const row: (number | null | undefined)[] = new Array(all.length).fill(undefined);
    places(c).forEach((at, i) => {
      if (at) row[first.get(at.x)! + at.k] = c.y[i] ?? null;
    });
    return row;
  });
  return [all, ...rows] as (number | null)[][];
}

/** A curve from point to point as the engine gives them: along a height x goes to and fro. */
function inOwnOrder(curve: Curve): uPlot.Series.PathBuilder {
  return (u) => {
    const stroke = new Path2D();
    let begun = false;
    curve.x.forEach((x, i) => {
      const y = curve.y[i];
      if (x == null || y == null) {
        begun = false;
        return;
      }
      const at = [u.valToPos(x, 'x', true), u.valToPos(y, 'y', true)] as const;
      if (begun) stroke.lineTo(...at);
      else stroke.moveTo(...at);
      begun = true;
    });
    return { stroke };
  };
}

/** The scale of a curve that is level but for its last digits: between two of its numbers there is no room for marks,
    and uPlot would look for them without an end. */
function spread(low: number | null, high: number | null): [number | null, number | null] {
  if (low === null || high === null) return [low, high];
  const size = Math.max(Math.abs(low), Math.abs(high));
  if (!(high - low < 1e-9 * size)) {
    return uPlot.rangeNum(low, high, 0.1, true);
  }
  return [low - 0.1 * size, high + 0.1 * size];
}

export class Plots {
  private shown: { plot: uPlot; over: PlotData['over']; box: HTMLElement }[] = [];

  constructor(private box: HTMLElement, private timeChosen: (scene: string, t: number) => void) {
    new ResizeObserver(() => this.resize()).observe(box);
  }

  show(plots: PlotData[], none = 'This deck has no plots.'): void {
    for (const one of this.shown) one.plot.destroy();
    this.shown = [];
    this.box.replaceChildren();
    if (plots.length === 0) this.box.append(el('p', { class: 'empty' }, none));
    const style = getComputedStyle(this.box);
    const colour = (name: string) => style.getPropertyValue(`--${name}`).trim();
    for (const plot of plots) {
      const figure = el('figure', {}, el('figcaption', {}, el('b', {}, plot.title)));
      const place = el('div', { class: 'plot', role: 'img', 'aria-label': `${plot.title}. ${plot.caption}` });
      figure.append(place, el('p', { class: 'caption' }, plot.caption));
      this.box.append(figure);
      const over = plot.over;
      const unit = (a: { label: string; unit: string }) => (a.unit ? `${a.label}, ${a.unit}` : a.label);
      const axis = { stroke: colour('soft'), grid: { stroke: colour('grid'), width: 1 }, ticks: { stroke: colour('grid') } };
      const u = new uPlot(
        {
          width: Math.max(place.clientWidth, 240),
          height: 240,
          scales: { x: { time: false }, y: { range: (_, low, high) => spread(low, high) } },
          axes: [
            { ...axis, label: unit(plot.x), size: 34, labelSize: 18 },
            { ...axis, label: unit(plot.y), size: 58, labelSize: 18 },
          ],
          series: [
            { label: unit(plot.x) },
            ...plot.curves.map((c, i) => ({
              label: c.label || plot.y.label,
              stroke: colour(pens[i % pens.length]!),
              width: 1.8,
              dash: c.dashed ? [6, 4] : undefined,
              paths: c.points ? () => null : inOwnOrder(c),
              points: { show: c.points ? true : undefined, size: 4 },
            })),
          ],
          hooks: {
            draw: [(u) => this.marks(u, plot, colour)],
            setCursor: [
              (u) => {
                const at = u.cursor.left;
                if (!over || at == null || at < 0 || !u.root.matches(':hover')) return;
                this.timeChosen(over.scene, u.posToVal(at, 'x') / over.second);
              },
            ],
          },
        },
        joined(plot) as uPlot.AlignedData,
        place,
      );
      this.shown.push({ plot: u, over, box: place });
    }
  }

  /** The cursor of all plots over the times of a scene stands at t, s. */
  setTime(scene: string, t: number): void {
    for (const { plot, over } of this.shown) {
      if (over?.scene !== scene || plot.root.matches(':hover')) continue;
      plot.setCursor({ left: plot.valToPos(t * over.second, 'x'), top: 10 }, false);
    }
  }

  resize(): void {
    for (const { plot, box } of this.shown) {
      if (box.clientWidth > 0 && box.clientWidth !== plot.width) plot.setSize({ width: box.clientWidth, height: 240 });
    }
  }

  private marks(u: uPlot, plot: PlotData, colour: (name: string) => string): void {
    const g = u.ctx;
    const ratio = window.devicePixelRatio || 1;
    g.save();
    g.strokeStyle = colour('force');
    g.fillStyle = colour('ink');
    g.lineWidth = ratio;
    g.font = `${11 * ratio}px system-ui, sans-serif`;
    for (const m of plot.marks) {
      const x = m.x == null ? NaN : u.valToPos(m.x, 'x', true);
      const y = m.y == null ? NaN : u.valToPos(m.y, 'y', true);
      const { left, top, width, height } = u.bbox;
      g.beginPath();
      if (m.level && y >= top && y <= top + height) {
        g.moveTo(left, y);
        g.lineTo(left + width, y);
        g.fillText(m.label, left + 6 * ratio, y - 4 * ratio);
      } else if (m.upright && x >= left && x <= left + width) {
        g.moveTo(x, top);
        g.lineTo(x, top + height);
        g.fillText(m.label, Math.min(x + 4 * ratio, left + width - g.measureText(m.label).width), top + 12 * ratio);
      } else if (!m.level && !m.upright && Number.isFinite(x + y)) {
        g.arc(x, y, 4 * ratio, 0, 2 * Math.PI);
        g.fillText(m.label, Math.min(x + 7 * ratio, left + width - g.measureText(m.label).width), y - 7 * ratio);
      }
      g.stroke();
    }
    g.restore();
  }
}
