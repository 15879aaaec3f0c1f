// Keys and choices where the cursor stands, from the schema that the engine makes of its descriptions.
import type { Completion, CompletionContext, CompletionResult } from '@codemirror/autocomplete';

interface Schema {
  $ref?: string;
  properties?: Record<string, Schema>;
  additionalProperties?: Schema | boolean;
  items?: Schema | Schema[];
  anyOf?: Schema[];
  oneOf?: Schema[];
  allOf?: Schema[];
  then?: Schema;
  else?: Schema;
  if?: Schema;
  definitions?: Record<string, Schema>;
  enum?: unknown[];
  const?: unknown;
  description?: string;
  type?: string | string[];
  default?: unknown;
  minItems?: number;
  maxItems?: number;
}

/** A key that may be written into a map, with the value that it starts with. */
export interface NewKey {
  name: string;
  words: string;
  value: string;
}

/** The keys above the cursor; `key`: one may be written here, else a value of the last of them. */
export interface Spot {
  path: string[];
  key: boolean;
  from: number;
}

const keyOf = /^(?:"([^"]*)"|'([^']*)'|([^\s"'#[\]{},:][^#[\]{},:]*?))\s*:(?=\s|$)/;

/** Reads from the top, as the text below may be in the making; lists count as `[]`. */
export function spotAt(text: string): Spot {
  const stack: { indent: number; name: string }[] = [];
  const lines = text.split('\n');
  let flow: string[] = [];
  let pending = '';
  let at = 0;
  let start = 0;
  let isKey = true;
  lines.forEach((line, n) => {
    let rest = line;
    let column = 0;
    const skip = (k: number) => {
      column += k;
      rest = rest.slice(k);
    };
    const spaces = /^ */.exec(rest)![0].length;
    skip(spaces);
    if (flow.length === 0 && (rest !== '' || n === lines.length - 1) && !rest.startsWith('#')) {
      const drop = () => {
        while (stack.length > 0 && stack.at(-1)!.indent >= column) stack.pop();
      };
      drop();
      pending = '';
      isKey = true;
      while (/^-(\s|$)/.test(rest)) {
        stack.push({ indent: column, name: '[]' });
        skip(/^-\s*/.exec(rest)![0].length);
      }
    }
    start = at + column;
    while (rest !== '') {
      const found = isKey ? keyOf.exec(rest) : null;
      const c = rest[0]!;
      if (found) {
        const name = found[1] ?? found[2] ?? found[3] ?? '';
        if (flow.length === 0) {
          while (stack.length > 0 && stack.at(-1)!.indent >= column) stack.pop();
          stack.push({ indent: column, name });
        }
        pending = name;
        isKey = false;
        skip(found[0].length);
        skip(/^\s*/.exec(rest)![0].length);
        start = at + column;
        continue;
      }
      if (c === '#' && (column === 0 || line[column - 1] === ' ')) break;
      if (c === '"' || c === "'") {
        const end = rest.indexOf(c, 1);
        skip(end < 0 ? rest.length : end + 1);
        continue;
      }
      if (c === '{' || c === '[') {
        flow.push((flow.length === 0 ? '' : pending) + (c === '[' ? '[]' : ''));
        pending = '';
        isKey = c === '{';
      } else if (c === '}' || c === ']') {
        flow.pop();
        isKey = false;
      } else if (c === ',' && flow.length > 0) {
        isKey = !flow.at(-1)!.endsWith('[]');
        pending = '';
      }
      skip(1);
      if ('{[,'.includes(c) || c === ' ') {
        skip(/^\s*/.exec(rest)![0].length);
        if ('{[,'.includes(c)) start = at + column;
      }
    }
    at += line.length + 1;
  });
  const inFlow = flow.flatMap((name) => (name.endsWith('[]') ? [name.slice(0, -2), '[]'] : [name])).filter((name) => name !== '');
  const path = [...stack.map((s) => s.name), ...inFlow];
  if (!isKey && flow.length > 0 && pending !== '') path.push(pending);
  flow = [];
  return { path, key: isKey, from: start };
}

/** What a key starts with; null for what is a map or a list of maps. */
function first(forms: Schema[]): string | null {
  const given = forms.find((f) => f.default !== undefined)?.default;
  if (given !== undefined) return String(given);
  const choices = forms.find((f) => f.enum)?.enum;
  if (choices) return String(choices[0]);
  const unit = /\[([^\]]+)\]/.exec(forms.find((f) => f.description)?.description ?? '')?.[1];
  const zero = unit ? `0 ${unit}` : '0';
  const is = (type: string) => forms.some((f) => [f.type].flat().includes(type));
  if (forms.some((f) => f.minItems === 3 && f.maxItems === 3)) return `[${zero}, ${zero}, ${zero}]`;
  if (is('boolean') && !is('string')) return 'true';
  if (unit || is('number') && !is('boolean') || is('integer')) return zero;
  return is('string') ? '""' : null;
}

export class Completer {
  private root: Schema | null = null;
  private asked: Promise<void> | null = null;

  constructor(private ask: () => Promise<string>) {}

  private load(): Promise<void> {
    this.asked ??= this.ask().then(
      (text) => { this.root = JSON.parse(text) as Schema; },
      () => { this.asked = null; },
    );
    return this.asked;
  }

  /** Every schema that may hold there: which alternative it is shows only in the whole deck. */
  private spread(all: Schema[], deep = 0): Schema[] {
    if (deep > 8) return all;
    return all.flatMap((s) => {
      const more: Schema[] = [];
      if (s.$ref) {
        const named = this.root?.definitions?.[decodeURIComponent(s.$ref.replace('#/definitions/', ''))];
        if (named) more.push(named);
      }
      more.push(...(s.anyOf ?? []), ...(s.oneOf ?? []), ...(s.allOf ?? []));
      if (s.then) more.push(s.then);
      if (s.else) more.push(s.else);
      return [s, ...(more.length > 0 ? this.spread(more, deep + 1) : [])];
    });
  }

  private below(all: Schema[], step: string): Schema[] {
    return this.spread(all).flatMap((s) => {
      if (step === '[]') return s.items ? [s.items].flat() : [];
      const own = s.properties?.[step];
      if (own) return [own];
      return typeof s.additionalProperties === 'object' ? [s.additionalProperties] : [];
    });
  }

  /** What the description says of a key; empty where it says nothing. */
  async words(path: string[]): Promise<string> {
    await this.load();
    if (!this.root) return '';
    const here = this.spread(path.reduce((all, step) => this.below(all, step), [this.root]));
    return here.find((s) => s.description)?.description ?? '';
  }

  /** The keys of a map that hold one value: its default, else zero of its unit, else an empty text. */
  async keys(path: string[]): Promise<NewKey[]> {
    await this.load();
    if (!this.root) return [];
    const here = this.spread(path.reduce((all, step) => this.below(all, step), [this.root]));
    const found = new Map<string, NewKey>();
    for (const s of here) {
      for (const [name, one] of Object.entries(s.properties ?? {})) {
        const forms = this.spread([one]);
        const value = first(forms);
        if (value === null || found.has(name)) continue;
        found.set(name, { name, words: forms.find((f) => f.description)?.description ?? '', value });
      }
    }
    return [...found.values()];
  }

  async complete(context: CompletionContext): Promise<CompletionResult | null> {
    const spot = spotAt(context.state.doc.sliceString(0, context.pos));
    if (!context.explicit && spot.from === context.pos) return null;
    await this.load();
    if (!this.root) return null;
    const here = this.spread(spot.path.reduce((all, step) => this.below(all, step), [this.root]));
    const options = new Map<string, Completion>();
    for (const s of here) {
      if (spot.key) {
        for (const [name, one] of Object.entries(s.properties ?? {})) {
          const words = one.description ?? this.spread([one]).find((o) => o.description)?.description ?? '';
          if (!options.get(name)?.info) options.set(name, { label: name, apply: `${name}: `, info: words, type: 'property' });
        }
      } else {
        for (const value of s.enum ?? (s.const !== undefined ? [s.const] : [])) {
          options.set(String(value), { label: String(value), type: 'enum' });
        }
      }
    }
    return options.size > 0 ? { from: spot.from, options: [...options.values()], validFor: /^[\w+-]*$/ } : null;
  }
}
