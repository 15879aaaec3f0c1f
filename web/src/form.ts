// The part under the cursor as a form: one field for each value that the deck gives, with the words of its description.
import { el } from './dom';
import type { NewKey } from './complete';
import type { OutlineNode, Places } from './types';

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

/** The innermost map around the cursor that has values of its own, and these. */
function partAt(places: Places, at: number, text: string): { part: OutlineNode; values: OutlineNode[] } | null {
  const outline = places.outline ?? [];
  const around = outline
    .filter((n) => n.kind === 'map' && (n.key?.[0] ?? n.value[0]) <= at && (at <= n.value[1] || onlyCloses(text.slice(n.value[1], at))))
    .sort((a, b) => b.path.length - a.path.length);
  for (const part of around) {
    const values = outline.filter((n) => {
      const rest = n.path.startsWith(`${part.path}.`) ? n.path.slice(part.path.length + 1) : '';
      return rest !== '' && !/[.[]/.test(rest) && n.kind === 'scalar';
    });
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

export class Form {
  private shown = '';

  constructor(
    private box: HTMLElement,
    private words: (path: string[]) => Promise<string>,
    private keys: (path: string[]) => Promise<NewKey[]>,
    private write: (change: Change) => void,
  ) {}

  /** `places` hold for the text as it stands; null: they do not. */
  show(places: Places | null, at: number, text: string): void {
    const found = places ? partAt(places, at, text) : null;
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
        input.addEventListener('change', () => {
          this.shown = '';
          this.write({ from: v.value[0], to: v.value[1], insert: input.value });
        });
        return field;
      }),
    );
    void this.offer(found.part, found.values, places?.outline ?? [], text);
  }

  /** The keys that the part has not. */
  private async offer(part: OutlineNode, values: OutlineNode[], outline: OutlineNode[], text: string): Promise<void> {
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
      if (!key) return;
      this.shown = '';
      add.blur();
      this.write(added(values, text, key));
    });
    this.box.append(el('span', { class: 'add' }, choice, add));
  }
}
