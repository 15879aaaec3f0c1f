// What a reader has typed stays: another deck can be undone, and a page that goes asks first and has the text when it is
// loaded again.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { example, link, opened, settled, text, verdict, write } from './page.mjs';

/** Kinds of the questions that the page asks; all are answered with yes. */
function questions(page) {
  const asked = [];
  page.on('dialog', (dialog) => {
    asked.push(dialog.type());
    void dialog.accept();
  });
  return asked;
}

test('undo takes another deck back: the text as it was, its name and its files', async () => {
  const { page, context, said } = await opened();
  const first = await text(page);
  await example(page, 'Three-span standing skyline, uphill');
  const name = await page.locator('#deck-name').innerText();
  const edited = (await text(page)).replace('title: Three', 'title: My three');
  await write(page, edited);
  await settled(page);
  const answer = await verdict(page);
  await example(page, 'Single span with a clamped load');
  assert.notEqual(await page.locator('#deck-name').innerText(), name);
  await page.locator('.cm-content').focus();
  await page.keyboard.press('Control+z');
  assert.equal(await text(page), edited);
  assert.equal(await page.locator('#deck-name').innerText(), name);
  await settled(page);
  // its terrain stands in another file
  assert.equal(await verdict(page), answer);
  await page.keyboard.press('Control+y');
  assert.match(await text(page), /title: Single span/);
  for (let i = 0; i < 9; ++i) await page.keyboard.press('Control+z');
  assert.equal(await text(page), first);
  // what the browser itself puts where a selection was written over
  assert.deepEqual(said.filter((s) => !/inline style/.test(s)), []);
  await context.close();
});

for (const linked of [false, true]) {
  test(`a page that is loaded again has the edits${linked ? ' of the deck of a link' : ''}, after a question`, async () => {
    const { page, context } = await opened();
    if (linked) {
      const other = link({ name: 'shared.yaml', text: await text(page), files: {} });
      await page.evaluate((hash) => { location.hash = hash; }, other);
      await page.waitForFunction(() => document.getElementById('deck-name').textContent === 'shared.yaml');
      await settled(page);
    }
    const asked = questions(page);
    await page.reload();
    await settled(page);
    assert.deepEqual(asked, []);
    const edited = (await text(page)).replace('900 kg', '1234 kg');
    await write(page, edited);
    await settled(page);
    const name = await page.locator('#deck-name').innerText();
    await page.reload();
    await settled(page);
    assert.deepEqual(asked, ['beforeunload']);
    assert.equal(await text(page), edited);
    assert.equal(await page.locator('#deck-name').innerText(), name);
    await context.close();
  });
}

test('a deck that was saved goes without a question', async () => {
  const { page, context } = await opened('', { acceptDownloads: true });
  const asked = questions(page);
  await write(page, (await text(page)).replace('900 kg', '1234 kg'));
  const download = page.waitForEvent('download');
  await page.click('#save');
  await download;
  await page.reload();
  await settled(page);
  assert.deepEqual(asked, []);
  await context.close();
});
