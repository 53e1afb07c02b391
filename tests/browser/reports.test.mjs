// The paper's tables and Figure 15, measured in the browser row by row, in windows that are opened from a menu.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { withOneBackend } from './backends.mjs';

const REPORTS = {
  'the accuracy of all methods and Figure 15': { entry: /^Figure 15 · /, rows: 3 },
  'the tables of the paper': { entry: /^Tables 1 and 2/, rows: 2 },
};

withOneBackend('reports', (bench) => {
  for (const [report, { entry, rows }] of Object.entries(REPORTS)) {
    test(
      `${report} fill row by row, and are closed by Escape`,
      bench.withApp(async (app) => {
        const session = await app.session();
        await app.walkTo(/^Figures, button/);
        await app.press('Space');
        await app.walkTo(entry);
        await app.press('Enter');
        const opened = await app.until('it is open', (stats) => stats.report !== null);
        const later = await app.until('there are several rows', (stats, count) => stats.report?.measured >= count, rows);
        const all = ({ report: { measured, left } }) => measured + left;
        assert.ok(all(later) >= all(opened), `every row is shown, or is still to come: ${all(later)} of ${all(opened)}`);
        assert.deepEqual(later.errors, []);
        await app.shot(`report-${rows}`);
        await app.press('Escape');
        await app.until('it is closed', (stats) => stats.report === null);
        assert.deepEqual(await app.session(), session, 'the map on the screen is as before');
      }),
    );
  }
});
