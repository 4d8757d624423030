// Leaves a hole open that is not in the review queue, from the table of holes, and downloads the decisions:
// decide_hole.mjs PAGE CHROMIUM FILE HOLE OTHER. The page has no outline of the hole OTHER. Prints what is wrong, one line each.
import { chromium } from 'playwright-core';

const [, , page, program, file, hole, other] = process.argv;
const browser = await chromium.launch({ executablePath: program, args: ['--no-sandbox'] });
const tab = await browser.newPage(), faults = [];
const expect = (holds, what) => { if (!holds) faults.push(what); };
tab.on('pageerror', (error) => faults.push(`error: ${error.message}`));
await tab.goto(`file://${page}`);
const rows = tab.locator('table.holes tbody tr'), queued = tab.locator('table.queue tbody tr');
expect(await queued.count() === 0, 'the queue has a fill, and none is in doubt');
expect(await tab.locator(`table.holes tr[data-hole="${other}"] .decidehole`).count() === 0, 'a hole without an outline is offered');
await tab.getByLabel('least crossings').fill('1');
expect(await rows.count() === 1 && await rows.first().getAttribute('data-hole') === hole, 'the holes are not filtered by crossings');
expect((await rows.first().innerText()).includes('5'), 'the table does not show the crossings');
await tab.locator('table.holes th button', { hasText: 'crossings' }).click();
expect((await rows.first().locator('.decidehole').boundingBox()).height >= 24, 'the button is less than 24 px high');
await rows.first().locator('.decidehole').click();
expect(await queued.count() === 1 && await queued.first().isVisible(), 'the hole has no row in the queue');
expect((await queued.first().innerText()).includes('5'), 'the queue does not show the crossings');
for (const text of ['lake', '1.250 \u00b1 0.125', '< 0.1']) {
  expect((await queued.first().innerText()).includes(text), `the queue does not show ${text}`);
}
await tab.keyboard.press('w');
expect(await queued.first().locator('.level').inputValue() === '1.250', 'the level of the rim is not entered');
await queued.first().focus();
await tab.keyboard.press('o');
expect(await tab.locator('.review [role=status]').innerText() === '1 other fill decided', 'the queue does not count the decision');
await tab.reload();
expect(await queued.first().locator('select').inputValue() === 'open', 'the decision is lost when the page is opened again');
const [download] = await Promise.all([tab.waitForEvent('download'), tab.locator('.review .download').click()]);
await download.saveAs(file);
await browser.close();
for (const fault of faults) console.log(fault);
process.exit(faults.length > 0 ? 1 : 0);
