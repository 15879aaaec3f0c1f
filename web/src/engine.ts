// The page's side of the engine: one worker, one calculation at a time, the latest deck wins.
import type { Answer, Deck, Progress } from './types';

interface Waiting {
  resolve: (answer: unknown) => void;
  reject: (why: Error) => void;
}

export class Stopped extends Error {}

/** A calculation that takes longer than this is ended when the deck has changed meanwhile. */
const patience = 1500;

export class Engine {
  onProgress: (progress: Progress | null) => void = () => {};
  version = '';
  private worker: Worker | null = null;
  private module: WebAssembly.Module | undefined;
  private ready: Promise<void> = Promise.resolve();
  private giveUp: (why: Error) => void = () => {};
  private waiting = new Map<number, Waiting>();
  private next = 1;
  private running: { began: number; done: Promise<unknown> } | null = null;
  private latest = 0;

  start(): Promise<void> {
    const blob = document.getElementById('taut-worker');
    const packed = document.getElementById('taut-engine');
    // a page from disk gives no worker from a file, so the text of the worker stands in the page
    const url = blob ? URL.createObjectURL(new Blob([blob.textContent ?? ''], { type: 'text/javascript' })) : 'worker.js';
    const worker = new Worker(url);
    this.worker = worker;
    this.ready = new Promise((resolve, reject) => {
      this.giveUp = reject;
      worker.onerror = (event) => reject(new Error(event.message || 'the engine cannot start'));
      worker.onmessage = (event: MessageEvent) => {
        const m = event.data;
        if (m.kind === 'ready') {
          this.module ??= m.module;
          this.version = m.version;
          resolve();
        } else if (m.kind === 'progress') {
          this.onProgress(m);
        } else if (m.kind === 'answer') {
          const one = this.waiting.get(m.id);
          this.waiting.delete(m.id);
          one?.resolve(m.answer);
        } else if (m.kind === 'broken') {
          this.end(new Error(m.text));
        }
      };
    });
    // who waits for it hears of it; nobody may wait
    this.ready.catch(() => {});
    worker.postMessage({
      kind: 'start',
      module: this.module,
      packed: this.module ? undefined : packed?.textContent?.trim(),
      url: 'engine.wasm',
    });
    return this.ready;
  }

  /** Ends what runs and starts anew; a worker that calculates hears nothing until it is done. */
  stop(why: Error = new Stopped('stopped')): Promise<void> {
    this.end(why);
    return this.start();
  }

  private end(why: Error): void {
    this.worker?.terminate();
    this.worker = null;
    const all = [...this.waiting.values()];
    this.waiting.clear();
    this.giveUp(why);
    for (const one of all) one.reject(why);
    this.onProgress(null);
  }

  private loaded(): Promise<void> {
    return this.worker ? this.ready : this.start();
  }

  private async call<T>(message: object): Promise<T> {
    await this.loaded();
    const id = this.next++;
    return new Promise<T>((resolve, reject) => {
      this.waiting.set(id, { resolve: resolve as (answer: unknown) => void, reject });
      this.worker?.postMessage({ ...message, id });
    });
  }

  /** Null: a later deck was given meanwhile. */
  async solve(deck: Deck): Promise<Answer | null> {
    const mine = ++this.latest;
    // what loads calculates nothing yet: a deck that comes meanwhile takes the place of the one before
    await this.loaded();
    if (mine !== this.latest) return null;
    while (this.running) {
      const left = patience - (performance.now() - this.running.began);
      const ended = this.running.done.catch(() => {});
      const pause = new Promise((resolve) => setTimeout(resolve, Math.max(left, 0), 'late'));
      if ((await Promise.race([ended, pause])) === 'late' && mine === this.latest && this.running) await this.stop();
      if (mine !== this.latest) return null;
    }
    const done = this.call<Answer>({ kind: 'solve', deck });
    const run = { began: performance.now(), done };
    this.running = run;
    try {
      const answer = await done;
      return mine === this.latest ? answer : null;
    } finally {
      if (this.running === run) this.running = null;
      this.onProgress(null);
    }
  }

  /** "report", "json" of the last result; "schema". */
  ask(what: string): Promise<string> {
    return this.call<string>({ kind: 'ask', what });
  }
}
