// Holds web/src/times.ts, built as MODULE, to the table of shares, and to times: times_test.mjs MODULE
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';

const { Rates, shareDone } = await import(pathToFileURL(process.argv[2]).href);
const table = new URL('progress_shares.txt', import.meta.url);

const rows = readFileSync(table, 'utf8').split('\n').filter((line) => line && !line.startsWith('#'));
assert.ok(rows.length > 10);
for (const row of rows) {
  const [phase, cells, cellsDone, tasks, tasksDone, share] = row.split(/ +/);
  const [done, of] = share.split('/').map(Number);
  assert.equal(shareDone({ progress: { phase, cells, cellsDone, tasks, tasksDone } }), done / of, row);
}

const now = Date.parse('2026-01-01T01:00:00Z');
const job = {
  name: 'jobs/1', createTime: '2026-01-01T00:00:00Z',
  progress: { phase: 'fill', cells: '10', cellsDone: '0', tasks: '20', tasksDone: '15' },  // half of all
};
assert.equal(new Rates().textOf(job, now), '0.3 tasks/min, 1 h 00 min left');
const queued = { ...job, startTime: '2026-01-01T00:59:00Z' };  // it was in the queue for 59 minutes
assert.equal(new Rates().textOf(queued, now), '15.0 tasks/min, 1 min 00 s left');
