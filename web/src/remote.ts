// The page's side of `taut serve`: the program calculates, the jobs live there and outlive this page (web/api.hpp).
import { Stopped } from './engine';
import type { Answer, Deck, PageEngine, Progress } from './types';

/** The page was sent by `taut serve`. */
export const served = document.documentElement.dataset.served !== undefined;

const token = new URLSearchParams(location.search).get('token') ?? '';
const kept = 'taut-job';

interface Job {
  id: string;
  name: string;
  state: 'waiting' | 'running' | 'done' | 'stopped' | 'failed';
  stopping: boolean;
  took: number;
  progress: Progress;
}

/** Asks the program; its own words are the error. */
export async function ask(method: string, path: string, body?: string, type = 'application/json'): Promise<Response> {
  let answer: Response;
  try {
    answer = await fetch(`api/${path}`, { method, headers: { 'X-Taut-Token': token, ...(body === undefined ? {} : { 'Content-Type': type }) }, body });
  } catch {
    throw new Error('taut serve does not answer; is it still running?');
  }
  if (!answer.ok) {
    const said = await answer.json().catch(() => ({}));
    throw new Error(said.error ?? `taut serve answers with ${answer.status}`);
  }
  return answer;
}

const same = (a: Deck, b: Deck) => a.name === b.name && a.text === b.text && JSON.stringify(a.files) === JSON.stringify(b.files);
const pause = (ms: number) => new Promise((resolve) => setTimeout(resolve, ms));

export class RemoteEngine implements PageEngine {
  onProgress: (progress: Progress | null) => void = () => {};
  version = '';
  private latest = 0;
  private running: Job | null = null;
  private shown = '';
  private found: { id: string; deck: Deck } | null = null;

  async start(): Promise<void> {
    this.version = (await (await ask('GET', 'hello')).json()).version;
  }

  /** The deck of this page's job before it was loaded again; else that of a job that is left from a closed page. */
  async earlier(): Promise<Deck | null> {
    try {
      const jobs: Job[] = (await (await ask('GET', 'jobs')).json()).jobs;
      const mine = sessionStorage.getItem(kept);
      const job = jobs.find((j) => j.id === mine) ?? [...jobs].reverse().find((j) => j.state === 'running' || j.state === 'waiting') ?? jobs.at(-1);
      if (!job) return null;
      const deck: Deck = await (await ask('GET', `jobs/${job.id}/deck`)).json();
      this.found = { id: job.id, deck: { name: deck.name, text: deck.text, files: deck.files } };
      return this.found.deck;
    } catch {
      return null; // it was forgotten meanwhile: the page begins anew
    }
  }

  /** True: the answer comes with what is done, from solve. */
  async stop(): Promise<boolean> {
    const job = this.running;
    if (!job) return false;
    await ask('POST', `jobs/${job.id}/stop`);
    return job.state !== 'waiting';
  }

  /** Null: a later deck was given meanwhile, and the job of this one is ended. */
  async solve(deck: Deck): Promise<Answer | null> {
    const mine = ++this.latest;
    const before = this.running;
    this.running = null;
    if (before) void ask('DELETE', `jobs/${before.id}`).catch(() => {});
    const found = this.found && same(this.found.deck, deck) ? this.found.id : null;
    this.found = null;
    const id = found ?? (await (await ask('POST', 'jobs', JSON.stringify(deck))).json()).id as string;
    if (mine !== this.latest) {
      void ask('DELETE', `jobs/${id}`).catch(() => {});
      return null;
    }
    sessionStorage.setItem(kept, id);
    try {
      const job = await this.ended(id, mine);
      if (!job) return null;
      const answer: Answer = await (await ask('GET', `jobs/${id}`)).json();
      if (mine !== this.latest) return null;
      if (job.state === 'stopped' && !answer.page) throw new Stopped('stopped');
      this.shown = id;
      return { ...answer, took: job.took };
    } finally {
      if (mine === this.latest) {
        this.running = null;
        this.onProgress(null);
      }
    }
  }

  /** "report", "json", "pictures" of the last result; "schema". */
  async ask(what: string): Promise<string> {
    if (what === 'schema') return (await ask('GET', 'schema')).text();
    return this.shown ? (await ask('GET', `jobs/${this.shown}/${what}`)).text() : '';
  }

  /** Null: nobody waits for it any more. */
  private async ended(id: string, mine: number): Promise<Job | null> {
    while (mine === this.latest) {
      const job = await this.listen(id, mine);
      if (job || mine !== this.latest) return job;
      // too many pages listen, or the connection broke: the job goes on
      await pause(1000);
      const answer = await ask('GET', `jobs/${id}`);
      if (answer.status === 200) return ((await (await ask('GET', 'jobs')).json()).jobs as Job[]).find((j) => j.id === id) ?? null;
    }
    return null;
  }

  /** The events of a job up to its end; null where they break off. */
  private listen(id: string, mine: number): Promise<Job | null> {
    return new Promise((resolve) => {
      const events = new EventSource(`api/jobs/${id}/events?token=${encodeURIComponent(token)}`);
      const end = (job: Job | null) => {
        events.close();
        resolve(job);
      };
      events.addEventListener('progress', (event) => {
        if (mine !== this.latest) return end(null);
        this.running = JSON.parse((event as MessageEvent).data) as Job;
        this.tell(this.running);
      });
      events.addEventListener('done', (event) => end(JSON.parse((event as MessageEvent).data) as Job));
      events.onerror = () => end(null);
    });
  }

  private tell(job: Job): void {
    if (job.state === 'waiting') this.onProgress({ what: 'waiting', done: 0, words: 'other calculations come first' });
    else if (job.stopping) this.onProgress({ ...job.progress, words: `${job.progress.words}, stopping` });
    else if (job.progress.what) this.onProgress(job.progress);
  }
}
