// node build.mjs ENGINE OUT: makes OUT/taut.html, one file that opens from disk, and OUT/site/, the same for a web space.
// ENGINE: folder with engine.js and engine.wasm. TAUT_WEB_ADDRESS: where the page stands on the web, for links.
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join, posix, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { build, minify } from 'vite';

const here = dirname(fileURLToPath(import.meta.url));
const root = dirname(here);
const [engine, out] = process.argv.slice(2);
if (!engine || !out) throw new Error('usage: node build.mjs ENGINE OUT');

async function bundled(entry) {
  const made = await build({
    configFile: false, root: here, logLevel: 'warn',
    build: { write: false, target: 'es2022', lib: { entry: join(here, 'src', entry), formats: ['iife'], name: 'tautPage' } },
  });
  return [made].flat()[0].output.find((o) => o.type === 'chunk').code;
}

/** Decks that run alone, each with the files that it and its parts name. */
function gallery() {
  const examples = join(root, 'examples');
  const all = readdirSync(examples, { recursive: true }).map(String).filter((f) => f.endsWith('.yaml') && !f.endsWith('.part.yaml'));
  const order = ['machines', 'motion', '', 'design', 'study', 'more', 'telescopic_boom'];
  return all.sort().map((name) => {
    const text = readFileSync(join(examples, name), 'utf8');
    const files = {};
    const take = (body, folder) => {
      for (const found of body.replace(/^\s*#.*$/gm, '').matchAll(/[\w./-]+\.(?:yaml|csv)\b/g)) {
        const path = posix.normalize(posix.join(folder, found[0]));
        const whole = join(examples, path);
        if (path in files || path === name || path.startsWith('..') || !existsSync(whole)) continue;
        files[path] = readFileSync(whole, 'utf8');
        take(files[path], posix.dirname(path));
      }
    };
    take(text, posix.dirname(name));
    const group = dirname(name) === '.' ? 'methods' : dirname(name).replaceAll('_', ' ');
    const title = /^title:\s*(.+?)\s*$/m.exec(text)?.[1]?.replace(/^(["'])(.*)\1$/, '$2') ?? posix.basename(name, '.yaml');
    return { name, title, group, text, files, folder: dirname(name) };
  }).sort((a, b) => order.indexOf(a.folder === '.' ? '' : a.folder) - order.indexOf(b.folder === '.' ? '' : b.folder))
    .map(({ folder, ...rest }) => rest);
}

const hash = (text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;
/** Nothing in a text of a script ends the element that holds it. */
const inScript = (text) => text.replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');
const inData = (text) => text.replaceAll('<', '\\u003c');

const page = inScript(await bundled('main.ts'));
const glue = await minify('engine.js', readFileSync(join(engine, 'engine.js'), 'utf8'), { module: false });
if (glue.errors.length > 0) throw new Error(`engine.js: ${glue.errors[0].message}`);
const worker = inScript(`${glue.code}\n${await bundled('worker.ts')}`);
const wasm = readFileSync(join(engine, 'engine.wasm'));
const style = readFileSync(join(here, 'node_modules/uplot/dist/uPlot.min.css'), 'utf8') + readFileSync(join(here, 'src/style.css'), 'utf8');
const data = inData(JSON.stringify(gallery()));
const nonce = createHash('sha256').update(page).update(style).digest('base64url').slice(0, 22);
const template = readFileSync(join(here, 'index.html'), 'utf8');

function policy(script) {
  return ["default-src 'none'", `script-src ${script} 'wasm-unsafe-eval'`, "worker-src 'self' blob:",
    `style-src 'self' 'nonce-${nonce}'`, 'img-src data: blob:', 'font-src data:', "connect-src 'self'", "base-uri 'none'",
    "form-action 'none'"].join('; ');
}
function filled(parts) {
  let html = template;
  const values = { NONCE: nonce, ADDRESS: process.env.TAUT_WEB_ADDRESS ?? '', ...parts };
  for (const [key, value] of Object.entries(values)) html = html.replaceAll(`%${key}%`, () => value);
  return html;
}

rmSync(out, { recursive: true, force: true });
mkdirSync(join(out, 'site'), { recursive: true });
const examples = `<script type="application/json" id="taut-gallery">${data}</script>`;
// a blob worker has the policy of its page: its text is named there as the page's own is
const one = filled({
  POLICY: policy(`${hash(page)} blob:`),
  STYLE: `<style nonce="${nonce}">${style}</style>`,
  BODY: `${examples}\n<script type="text/plain" id="taut-worker">${worker}</script>
<script type="text/plain" id="taut-engine">${gzipSync(wasm, { level: 9 }).toString('base64')}</script>
<script>${page}</script>`,
});
writeFileSync(join(out, 'taut.html'), one);
writeFileSync(join(out, 'site', 'index.html'), filled({
  POLICY: policy("'self'"),
  STYLE: `<link rel="stylesheet" href="style.css">`,
  BODY: `${examples}\n<script src="page.js" defer></script>`,
}));
for (const [name, text] of [['page.js', page], ['worker.js', worker], ['style.css', style], ['engine.wasm', wasm]]) {
  writeFileSync(join(out, 'site', name), text);
}
console.log(`${relative(process.cwd(), join(out, 'taut.html'))}: ${(one.length / 1e6).toFixed(2)} MB`);
