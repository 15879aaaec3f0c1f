// The part under the cursor as a form: one field for each value that the deck gives, with the words of its description.
import { el } from './dom';
import type { NewKey } from './complete';
import type { OutlineNode } from './types';

export interface Change {
  from: number;
  to: number;
  insert: string;
  /** What shall be selected of the text behind, as it is a value to be written. */
  select?: [number, number];
}

/** "machine.sheaves.a.at[0]" as steps of a schema. */
export function steps(path: string): string[] {
  return path.split('.').flatMap((part) => part.split(/(?=\[)/).map((p) => (p.startsWith('[') ? '[]' : p)));
}

/** The rest of the line behind a part: brackets and a comment. */
function onlyCloses(rest: string): boolean {
  return /^[ \t}\],]*(#[^\n]*)?$/.test(rest);
}

/** The values that stand in a map itself. */
function valuesIn(part: string, outline: OutlineNode[]): OutlineNode[] {
  return outline.filter((n) => {
    const rest = n.path.startsWith(`${part}.`) ? n.path.slice(part.length + 1) : '';
    return rest !== '' && !/[.[]/.test(rest) && n.kind === 'scalar';
  });
}

/** The innermost map around the cursor that has values of its own, and these. */
function partAt(outline: OutlineNode[], at: number, text: string): { part: OutlineNode; values: OutlineNode[] } | null {
  const around = outline
    .filter((n) => n.kind === 'map' && (n.key?.[0] ?? n.value[0]) <= at && (at <= n.value[1] || onlyCloses(text.slice(n.value[1], at))))
    .sort((a, b) => b.path.length - a.path.length);
  for (const part of around) {
    const values = valuesIn(part.path, outline);
    if (values.length > 0) return { part, values };
  }
  return null;
}

/** A key behind the last value of a part, as the part is written: in brackets, or on a line with the same indentation.
    A comment behind that value stays with it. */
export function added(values: OutlineNode[], text: string, key: NewKey): Change {
  const last = values.reduce((a, b) => (b.value[1] > a.value[1] ? b : a));
  const first = Math.min(...values.map((v) => v.key?.[0] ?? v.value[0]));
  const start = last.key?.[0] ?? last.value[0];
  const line = text.lastIndexOf('\n', start - 1) + 1;
  const before = text.slice(line, start);
  // in a block nothing but spaces, dashes and the keys above stand before a key
  const inBrackets = /[{,]\s*$/.test(before) || /[{,]\s*$/.test(text.slice(0, first));
  const end = text.indexOf('\n', last.value[1]);
  const at = inBrackets ? last.value[1] : end < 0 ? text.length : end;
  const lead = inBrackets ? `, ${key.name}: ` : `\n${' '.repeat(start - line)}${key.name}: `;
  const from = at + lead.length;
  return { from: at, to: at, insert: lead + key.value, select: [from, from + key.value.length] };
}

/** The deck whose parts a form shows. */
export interface FormDeck {
  text(): string;
  /** Of the text as it stands; null: not known. */
  outline(): OutlineNode[] | null;
  /** Puts a value in place of another one. */
  replace(change: Change): void;
  /** Puts a new key into the deck. */
  add(change: Change): void;
  refuse(words: string): void;
}

export class Form {
  private shown = '';

  constructor(
    private box: HTMLElement,
    private words: (path: string[]) => Promise<string>,
    private keys: (path: string[]) => Promise<NewKey[]>,
    private deck: FormDeck,
  ) {}

  /** The part at the cursor. */
  show(at: number): void {
    const outline = this.deck.outline();
    const text = this.deck.text();
    const found = outline && partAt(outline, at, text);
    this.box.hidden = !found;
    if (!found) {
      this.shown = '';
      return;
    }
    const state = `${found.part.path} ${found.values.map((v) => text.slice(...v.value)).join('|')}`;
    if (state === this.shown || this.box.contains(document.activeElement)) return;
    this.shown = state;
    this.box.replaceChildren(
      el('b', {}, found.part.path),
      ...found.values.map((v) => {
        const name = v.path.slice(found.part.path.length + 1);
        const input = el('input', { value: text.slice(...v.value), spellcheck: 'false' });
        const field = el('label', {}, name, input);
        void this.words(steps(v.path)).then((words) => {
          field.title = words;
        });
        let before = input.value;
        input.addEventListener('change', () => {
          this.shown = '';
          const done = this.write(v.path, before, input.value);
          if (done) before = input.value;
          input.setAttribute('aria-invalid', String(!done));
        });
        return field;
      }),
    );
    void this.offer(found.part, outline ?? []);
  }

  /** False where the deck has another value than the field has shown, or its place is not known. */
  private write(path: string, before: string, value: string): boolean {
    const nodes = (this.deck.outline() ?? []).filter((n) => n.path === path);
    const node = nodes[0];
    if (!node || nodes.length > 1 || this.deck.text().slice(...node.value) !== before) {
      this.deck.refuse(`The deck has changed meanwhile: ${path} is not written.`);
      return false;
    }
    this.deck.replace({ from: node.value[0], to: node.value[1], insert: value });
    return true;
  }

  /** The keys that the part has not. */
  private async offer(part: OutlineNode, outline: OutlineNode[]): Promise<void> {
    const mine = this.shown;
    const has = new Set(outline.filter((n) => n.path.startsWith(`${part.path}.`)).map((n) => n.path.slice(part.path.length + 1)));
    const more = (await this.keys(steps(part.path))).filter((k) => !has.has(k.name));
    if (mine !== this.shown || more.length === 0) return;
    const choice = el('select', { 'aria-label': `key to add to ${part.path}` }, ...more.map((k) => el('option', { title: k.words }, k.name)));
    const add = el('button', { type: 'button' }, 'Add');
    const tell = () => { choice.title = more[choice.selectedIndex]?.words ?? ''; };
    choice.addEventListener('change', tell);
    tell();
    add.addEventListener('click', () => {
      const key = more[choice.selectedIndex];
      const values = valuesIn(part.path, this.deck.outline() ?? []);
      if (!key) return;
      if (values.length === 0) return this.deck.refuse(`The deck has changed meanwhile: ${key.name} is not added.`);
      this.shown = '';
      add.blur();
      this.deck.add(added(values, this.deck.text(), key));
    });
    this.box.append(el('span', { class: 'add' }, choice, add));
  }
}
