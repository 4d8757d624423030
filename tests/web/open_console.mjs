// Opens the coordinator's page in Chromium and uses it: open_console.mjs URL CHROMIUM FOLDER STEP. Prints what is wrong,
// one line each. Writes STEP.png to FOLDER. Waits for a line on its input where the test has to do something.
import { join } from 'node:path';
import { createInterface } from 'node:readline';
import { Console } from './console_tab.mjs';

const [, , url, program, folder, chosen] = process.argv;
const lines = createInterface({ input: process.stdin })[Symbol.asyncIterator]();
const ask = async (what) => { console.log(`DO ${what}`); await lines.next(); };
const page = await Console.start(url, program);
const expect = page.expect.bind(page);

const tab = await page.open('light', 'ann', chosen);
const job = (n) => tab.locator('.job').nth(n);
expect(await tab.locator('.job').count() === 3, `${await tab.locator('.job').count()} jobs are shown`);
await tab.waitForSelector('table.holes tbody tr', { timeout: 20000 });
const cells = await tab.locator('svg.map rect').count();
expect(cells === 12, `the map has ${cells} cells`);
expect(await tab.locator('svg.map rect.written').count() >= 8, 'cells are not shown as written');

// The map and the holes show each other.
const rows = tab.locator('table.holes tbody tr');
const all = await rows.count();
await tab.locator('svg.map rect').first().click();
expect(await rows.count() < all, 'a click on a cell does not choose its holes');
await tab.locator('.filters input[type=search]').fill('');
await tab.locator('.filters input.least').first().fill('10');
expect(await rows.count() < all && await rows.count() > 0, 'the least area does not choose');
await rows.first().click();
expect(await tab.locator('svg.map rect.chosen').count() === 1, 'a click on a hole does not mark its cell');
await tab.locator('.detail button', { hasText: 'before and after' }).click();
await tab.waitForSelector('.detail .card[data-loaded=yes]', { timeout: 20000 });
const pixels = () => tab.locator('.detail .view:not(.print)').evaluate((canvas) => canvas
  .getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.reduce((sum, value) => sum + value, 0));
const pictures = new Set();
for (const mode of ['before', 'after', 'marked']) {
  await tab.locator('.detail .modes button', { hasText: mode }).click();
  pictures.add(await pixels());
}
expect(pictures.size === 3, `before, after and marked show ${pictures.size} pictures`);
await page.checkAccess(tab, 'job');
await tab.evaluate(() => scrollTo(0, 0));
await tab.screenshot({ path: join(folder, 'console_job.png'), fullPage: true });
await tab.locator('svg.map').focus();
await tab.keyboard.press('ArrowRight');
await tab.keyboard.press('Enter');
expect((await tab.locator('.detail p').first().innerText()).startsWith('cell'), 'the keyboard chooses no cell');
expect((await tab.locator('main').innerText()).includes('<img src=x onerror=alert(1)>'), 'a name with markup is not shown as it is');

// A large map, and steering.
const large = tab.locator('.job', { hasText: 'large' });
await large.locator('.name').click();
await tab.waitForFunction(() => document.querySelectorAll('svg.map rect').length === 10000, null, { timeout: 30000 });
expect(await large.locator('.state').innerText() === 'paused', 'the paused job is not shown as paused');
await large.locator('button', { hasText: 'resume' }).click();
await tab.waitForFunction(() => [...document.querySelectorAll('.job')].some((j) => j.textContent.includes('large') && j.querySelector('button[hidden]') && j.textContent.includes('pause') && !j.querySelector('.state').textContent.includes('paused')));
await large.locator('button', { hasText: 'pause' }).click();
await tab.waitForFunction(() => document.querySelector('.job.chosen .state')?.textContent === 'paused');
await large.locator('.priority').fill('7');
await large.locator('.priority').blur();
expect(await tab.locator('td.doing').count() >= 1, 'no worker is shown');
await tab.evaluate(() => scrollTo(0, 0));
await tab.screenshot({ path: join(folder, 'console_large.png') });

// The coordinator is killed and comes back.
page.mayFail = true;
await ask('kill');
await tab.waitForFunction(() => document.querySelector('[role=alert]')?.textContent.includes('does not answer'), null, { timeout: 20000 });
expect(await tab.locator('.job').count() === 3, 'the jobs are gone while the coordinator is down');
await ask('start');
await tab.waitForFunction(() => document.querySelector('[role=alert]')?.hidden, null, { timeout: 30000 });
page.mayFail = false;
expect(await large.locator('.priority').inputValue() === '7', 'the priority was not kept');
await large.locator('button', { hasText: 'cancel' }).click();
await large.locator('button', { hasText: 'really' }).click();
await tab.waitForFunction(() => document.querySelector('.job.chosen .state')?.textContent === 'cancelled', null, { timeout: 20000 });
await job(2).locator('.name').click();
await tab.waitForSelector('table.holes tbody tr', { timeout: 20000 });
expect(await tab.locator('svg.map rect.written').count() >= 8, 'after a restart cells are not shown as written');

// Who may watch alone has no buttons.
const watcher = await page.open('dark', 'eve', chosen);
await watcher.waitForSelector('.job');
expect(await watcher.locator('.steer:not([hidden])').count() === 0, 'who may watch alone is shown buttons');
await page.checkAccess(watcher, 'dark');
await watcher.screenshot({ path: join(folder, 'console_dark.png') });
await page.end();
