// The motions of an answer: which one is shown, its slider, its events, and the button that plays it.
import { byId, el } from './dom';
import type { Scene } from './types';

/** "motion_long" is the motion with the name long; the first one without a name has no ending. */
const named = (scene: Scene) => scene.name.replace(/^motion_?/, '').replaceAll('_', ' ') || '1';

export class Player {
  private motions: Scene[] = [];
  private scene: Scene | null = null;
  private playing = 0;
  private readonly choice = byId<HTMLSelectElement>('motion');
  private readonly slider = byId<HTMLInputElement>('time');

  /** `chosen`: another motion is to be shown. `moved`: to a frame of it, at t; `tell`: the plots shall follow. */
  constructor(
    private readonly chosen: (scene: Scene) => void,
    private readonly moved: (frame: number, scene: Scene | null, t: number, tell: boolean) => void,
  ) {
    byId('play').addEventListener('click', () => this.play());
    this.slider.addEventListener('input', () => {
      this.stop();
      this.setFrame(Number(this.slider.value), true);
    });
    this.choice.addEventListener('change', () => {
      this.scene = this.motions.find((s) => s.name === this.choice.value) ?? this.scene;
      if (this.scene) this.chosen(this.scene);
    });
  }

  /** The scene to be shown of an answer: the motion chosen before, else the first one, else the machine at rest. */
  take(scenes: Scene[]): Scene | null {
    const before = this.scene?.name;
    this.motions = scenes.filter((s) => s.t.length > 1);
    this.scene = this.motions.find((s) => s.name === before) ?? this.motions[0] ?? scenes[0] ?? null;
    this.choice.replaceChildren(...this.motions.map((s) => el('option', { value: s.name }, named(s))));
    this.choice.value = this.scene?.name ?? '';
    byId('motions').hidden = this.motions.length < 2;
    byId('player').hidden = this.motions.length === 0;
    return this.scene;
  }

  /** To the first frame of the scene. */
  rewind(): void {
    this.stop();
    this.slider.max = String((this.scene?.t.length ?? 1) - 1);
    this.setFrame(0, false);
  }

  /** To a time of a scene, where that is the one that is shown. */
  point(scene: string, t: number): void {
    if (scene === this.scene?.name) this.setFrame(this.nearest(t), false);
  }

  private nearest(t: number): number {
    const all = this.scene?.t ?? [0];
    let best = 0;
    for (let i = 0; i < all.length; ++i) if (Math.abs(all[i]! - t) < Math.abs(all[best]! - t)) best = i;
    return best;
  }

  private setFrame(frame: number, tell: boolean): void {
    const t = this.scene?.t[frame] ?? 0;
    this.slider.value = String(frame);
    byId('now').textContent = this.scene?.times[frame] ?? '';
    byId('event').textContent = this.scene?.events.filter((e) => e.t <= t).at(-1)?.text ?? '';
    this.moved(frame, this.scene, t, tell);
  }

  private stop(): void {
    cancelAnimationFrame(this.playing);
    this.playing = 0;
    byId('play').textContent = 'Play';
  }

  private play(): void {
    if (this.playing) return this.stop();
    const all = this.scene?.t ?? [0];
    const frame = Number(this.slider.value);
    const from = all[frame >= all.length - 1 ? 0 : frame] ?? 0;
    const began = performance.now();
    byId('play').textContent = 'Pause';
    const step = () => {
      const t = from + (performance.now() - began) / 1000;
      this.setFrame(this.nearest(t), true);
      if (t >= (all.at(-1) ?? 0)) return this.stop();
      this.playing = requestAnimationFrame(step);
    };
    this.playing = requestAnimationFrame(step);
  }
}
