// The engine in node, as the worker of the page starts it, and the examples of the page.
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = dirname(dirname(dirname(fileURLToPath(import.meta.url))));
const folder = join(root, 'build-web/web');

export async function engine() {
  // the glue is a classic script, and the folder of a package of modules would make it one of them
  const glue = join(root, 'build-web/engine.cjs');
  writeFileSync(glue, readFileSync(join(folder, 'engine.js')));
  const make = createRequire(import.meta.url)(glue);
  const m = await make({ wasmBinary: readFileSync(join(folder, 'engine.wasm')) });
  const call = (name, text) => {
    const bytes = m.lengthBytesUTF8(text) + 1;
    const at = m._malloc(bytes);
    m.stringToUTF8(text, at, bytes);
    const answer = m.UTF8ToString(m[name](at));
    m._free(at);
    return answer;
  };
  return {
    solve: (deck) => JSON.parse(call('_taut_solve', JSON.stringify(deck))),
    ask: (what) => call('_taut_ask', what),
  };
}

export const html = () => readFileSync(join(root, 'build-web/page/taut.html'), 'utf8');

export function examples() {
  const found = /<script type="application\/json" id="taut-gallery">(.*?)<\/script>/s.exec(html());
  return JSON.parse(found[1]);
}

/** Whether a deck calculates a motion: its numbers agree to less, and it takes longer. */
export const isMotion = (deck) => /^\s*- transient:/m.test(Object.values(deck.files).concat(deck.text).join('\n'));

/** The deck with its files in a folder of its own, run there by the native program. */
export function native(deck, ...more) {
  const place = mkdtempSync(join(tmpdir(), 'taut-'));
  try {
    for (const [name, text] of Object.entries({ ...deck.files, [deck.name]: deck.text })) {
      mkdirSync(dirname(join(place, name)), { recursive: true });
      writeFileSync(join(place, name), text);
    }
    const options = { cwd: place, encoding: 'utf8', maxBuffer: 2 ** 30, stdio: ['ignore', 'pipe', 'ignore'] };
    try {
      return execFileSync(join(root, 'build/bin/taut'), ['run', deck.name, ...more], options);
    } catch (error) {
      if (error.status === 3 || error.status === 4) return error.stdout; // an answer with another verdict
      throw error;
    }
  } finally {
    rmSync(place, { recursive: true });
  }
}
