// Looks at holes before and after in the coordinator's page: open_pictures.mjs URL CHROMIUM FOLDER NAME=JOB... Prints what
// is wrong, one line each. Writes console_NAME.png to FOLDER.
import { join } from 'node:path';
import { Console } from './console_tab.mjs';

const [, , url, program, folder, ...jobs] = process.argv;
const page = await Console.start(url, program);
const [firstName, firstJob] = jobs[0].split('=');
const tab = await page.open('light', 'ann', firstJob);

// How many pixels of the picture are of each colour, and a number that another picture does not have.
const look = () => tab.locator('.detail .view:not(.print)').evaluate((canvas) => {
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  const counts = { red: 0, green: 0, drawn: 0, sum: 0 };
  for (let i = 0; i < data.length; i += 4) {
    if (data[i + 3] === 0) continue;
    ++counts.drawn;
    counts.sum = (counts.sum * 31 + data[i] + 7 * data[i + 1] + 13 * data[i + 2]) % 1000003;
    if (data[i] > 1.6 * data[i + 1]) ++counts.red;
    if (data[i + 1] > 1.15 * data[i] && data[i + 1] > 1.15 * data[i + 2]) ++counts.green;
  }
  return counts;
});

async function check(name, job) {
  await tab.evaluate((hash) => { location.hash = hash; }, job);
  await tab.waitForSelector(`.jobview[data-job="${job}"] table.holes tbody tr`, { timeout: 20000 });
  await tab.locator('table.holes th button', { hasText: 'area' }).click();
  await tab.locator('table.holes tbody tr').first().click();
  await tab.locator('.detail button', { hasText: 'before and after' }).click();
  await tab.waitForSelector('.detail .card[data-loaded=yes]', { timeout: 60000 })
    .catch(async () => page.faults.push(`${name}: ${await tab.locator('.detail .card').innerText()}`));
  const pressed = await tab.locator('.detail .modes button[aria-pressed=true]').innerText();
  page.expect(pressed === 'after', `${name}: the picture has no image: it is shown as ${pressed}`);
  const seen = {};
  for (const mode of ['before', 'after', 'marked']) {
    await tab.locator('.detail .modes button', { hasText: mode }).click();
    seen[mode] = await look();
  }
  const sums = new Set(Object.values(seen).map(({ sum }) => sum));
  page.expect(sums.size === 3, `${name}: before, after and marked show ${sums.size} pictures`);
  page.expect(seen.before.green > 1000, `${name}: the picture has not the colours of the image: ${JSON.stringify(seen.before)}`);
  page.expect(name === 'osgb' || seen.before.red > 1000, `${name}: a half of the image is not seen: ${JSON.stringify(seen.before)}`);
  page.expect(seen.after.drawn > 1.05 * seen.before.drawn, `${name}: no hole is closed: ${JSON.stringify(seen)}`);
  await tab.locator('.detail .modes button', { hasText: 'after' }).click();
  await tab.evaluate(() => scrollTo(0, document.querySelector('.jobview').offsetTop - 10));
  await tab.screenshot({ path: join(folder, `console_${name}.png`) });
}

// A cell without holes, of a model that is compressed.
async function checkCell(name, job) {
  await tab.evaluate((hash) => { location.hash = hash; }, job);
  await tab.waitForSelector(`.jobview[data-job="${job}"] svg.map rect.written`, { timeout: 20000 });
  await tab.locator('svg.map rect').first().click();
  await tab.locator('.detail button', { hasText: 'before and after' }).click();
  await tab.waitForSelector('.detail .card[data-loaded=yes]', { timeout: 60000 })
    .catch(async () => page.faults.push(`${name}: ${await tab.locator('.detail .card').innerText()}`));
  page.expect((await look()).drawn > 10000, `${name}: nothing is drawn`);
}

for (const entry of jobs) await (entry.startsWith('draco') ? checkCell : check)(...entry.split('='));

// From a hole to its row in the review queue.
await tab.evaluate((hash) => { location.hash = hash; }, firstJob);
await tab.waitForSelector(`.jobview[data-job="${firstJob}"] table.holes tbody tr`, { timeout: 20000 });
await tab.waitForSelector('.jobview .offer button', { timeout: 20000 })
  .catch(() => page.faults.push('what waits for a decision is not told'));
await tab.locator('table.holes th button', { hasText: /^doubt/ }).click();
await tab.locator('table.holes tbody tr').first().click();
await tab.locator('.detail .toreview').click();
await tab.waitForSelector('table.queue tbody tr:focus', { timeout: 20000 });
const command = await tab.locator('.review .command code').innerText();
page.expect(/ --coordinator 127\.0\.0\.1:[0-9]+$/.test(command), `the command does not name the coordinator: ${command}`);
await tab.keyboard.press('o');
page.expect((await tab.locator('.review [role=status]').innerText()).startsWith('1 of'), 'the queue does not take a decision');
await page.checkAccess(tab, firstName);
await page.end();
