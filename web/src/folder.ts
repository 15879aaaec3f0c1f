// The files of the folder that `taut serve` was given, to open and to save.
import { byId, el } from './dom';
import { ask } from './remote';
import type { Deck } from './types';

export interface Desk {
  open(deck: Deck): void;
  deck(): Deck;
  saved(as: string): void;
  announce(words: string): void;
}

export class FolderFiles {
  private names: string[] = [];
  /** The file that the deck was opened from or saved as. */
  private mine = '';
  private readonly choice = el('select', { id: 'files' });

  constructor(private readonly desk: Desk) {
    byId('examples').closest('label')?.before(el('label', {}, 'File ', this.choice));
    this.choice.addEventListener('focus', () => void this.list());
    this.choice.addEventListener('change', () => void this.open(this.choice.value));
    // a deck from elsewhere may have the same name
    for (const id of ['examples', 'file']) byId(id).addEventListener('change', () => this.forget());
    window.addEventListener('hashchange', () => this.forget());
    void this.list();
  }

  forget(): void {
    this.mine = '';
    this.choice.value = '';
  }

  private async list(): Promise<void> {
    try {
      this.names = (await (await ask('GET', 'files')).json()).names;
    } catch (error) {
      this.desk.announce((error as Error).message);
    }
    const first = el('option', { value: '' }, this.names.length === 0 ? 'no deck in the folder' : 'choose');
    this.choice.replaceChildren(first, ...this.names.filter((name) => !name.endsWith('.csv')).map((name) => el('option', { value: name }, name)));
    this.choice.value = this.mine;
  }

  private async open(name: string): Promise<void> {
    if (!name) return;
    try {
      const text = await (await ask('GET', `file?name=${encodeURIComponent(name)}`)).text();
      this.mine = name;
      // what it names is read in the folder
      this.desk.open({ name, text, files: {} });
    } catch (error) {
      this.desk.announce((error as Error).message);
    }
  }

  async save(): Promise<void> {
    const deck = this.desk.deck();
    const known = deck.name === this.mine;
    if (!known) await this.list();
    const usual = this.names.includes(deck.name) ? deck.name : deck.name.split('/').at(-1);
    const name = known ? this.mine : window.prompt('Save in the folder as', usual)?.trim();
    if (!name) return;
    if (!known && this.names.includes(name) && !window.confirm(`Write over ${name}?`)) return;
    try {
      await ask('PUT', `file?name=${encodeURIComponent(name)}`, deck.text, 'text/plain');
      this.mine = name;
      this.desk.saved(name);
      this.desk.announce(`Saved ${name}.`);
      await this.list();
    } catch (error) {
      this.desk.announce((error as Error).message);
    }
  }
}
