// Edits that are in no file and no link yet: the browser asks before the page goes, and a page that is loaded again has
// them.
import type { Deck } from './types';

const kept = 'taut-draft';

export class Draft {
  private saved = '';

  constructor(private readonly deck: () => Deck) {
    window.addEventListener('beforeunload', (event) => {
      if (this.unsaved) event.preventDefault();
    });
    window.addEventListener('pagehide', () => this.keep());
  }

  /** The text stands elsewhere, too: in a file, a link, or the examples. */
  isSaved(): void {
    this.saved = this.deck().text;
  }

  /** What the page had when it was loaded again; null: nothing that is not elsewhere. */
  before(): Deck | null {
    const [how] = performance.getEntriesByType('navigation') as PerformanceNavigationTiming[];
    if (how?.type !== 'reload' && how?.type !== 'back_forward') return null;
    try {
      const deck = JSON.parse(sessionStorage.getItem(kept) ?? 'null') as Deck | null;
      return typeof deck?.text === 'string' ? { name: String(deck.name), text: deck.text, files: deck.files ?? {} } : null;
    } catch {
      return null;
    }
  }

  private get unsaved(): boolean {
    return this.deck().text !== this.saved;
  }

  private keep(): void {
    try {
      if (this.unsaved) sessionStorage.setItem(kept, JSON.stringify(this.deck()));
      else sessionStorage.removeItem(kept);
    } catch {
      // no storage, or a deck that is too large for it: the question of the browser has to do
    }
  }
}
