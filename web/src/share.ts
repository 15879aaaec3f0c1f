// A machine in a link: the deck and what it names, packed, behind `#deck=`; no server sees it.
import type { Deck } from './types';

/** Longer links are cut by mail programs. */
export const longestLink = 8192;

async function through(bytes: Uint8Array<ArrayBuffer>, stream: GenericTransformStream): Promise<Uint8Array<ArrayBuffer>> {
  const readable = new Blob([bytes]).stream().pipeThrough(stream as ReadableWritablePair<Uint8Array<ArrayBuffer>>);
  return new Uint8Array(await new Response(readable).arrayBuffer());
}

export async function packed(deck: Deck): Promise<string> {
  const json = new TextEncoder().encode(JSON.stringify({ name: deck.name, text: deck.text, files: deck.files }));
  const bytes = await through(json, new CompressionStream('deflate-raw'));
  let text = '';
  for (const byte of bytes) text += String.fromCharCode(byte);
  return btoa(text).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

/** Null for what is no deck. A link is of anybody: what it holds is text for the editor, never anything else. */
export async function unpacked(hash: string): Promise<Deck | null> {
  const found = /^#deck=([A-Za-z0-9_-]+)$/.exec(hash);
  if (!found) return null;
  try {
    const text = atob((found[1] ?? '').replaceAll('-', '+').replaceAll('_', '/'));
    const bytes = Uint8Array.from(text, (c) => c.charCodeAt(0));
    const deck = JSON.parse(new TextDecoder().decode(await through(bytes, new DecompressionStream('deflate-raw'))));
    if (typeof deck.text !== 'string') return null;
    const files: Record<string, string> = {};
    for (const [name, file] of Object.entries(deck.files ?? {})) {
      if (typeof file === 'string') files[name] = file;
    }
    return { name: typeof deck.name === 'string' ? deck.name : 'deck.yaml', text: deck.text, files };
  } catch {
    return null;
  }
}
