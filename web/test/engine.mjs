// The engine in node, as the worker of the page starts it, and the examples of the page.
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
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
