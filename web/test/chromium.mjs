// The page in Chromium, from disk: for tests and for measurements.
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';
import { root } from './engine.mjs';

export const address = pathToFileURL(join(root, 'build-web/page/taut.html')).href;

export const launched = () =>
  chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox'] });

/** Waits for the answer of the deck in the editor; a deck with mistakes in place of the first answer is an error. */
export async function settled(page) {
  const bad = await page.waitForFunction(() => {
    const solved = document.getElementById('took').textContent !== '';
    if (!solved && document.getElementById('verdict').dataset.kind === 'bad') return document.getElementById('notes').innerText;
    return solved && !document.getElementById('machine').classList.contains('old') ? ' ' : '';
  }, null, { timeout: 300000 });
  const words = (await bad.jsonValue()).trim();
  if (words) throw new Error(words);
}
