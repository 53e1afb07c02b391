// The phone: the sheet leaves half of the height to the pictures, undo and redo are in sight, words for fingers.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { withOneBackend } from './backends.mjs';

const LYING = { device: 'phone', viewport: { width: 844, height: 390 } };

withOneBackend('phone', (bench) => {
  test(
    'beside an open sheet all dots are in the upper half of the screen',
    bench.withApp(
      async (app) => {
        for (const tab of [/^Controls, button/, /^Plots, button/]) {
          const closed = await app.stats();
          await app.walkTo(tab);
          await app.press('Space');
          const { handles } = await app.atRest('it is open', (stats, y) => stats.handles.x2[1] !== y, closed.handles.x2[1]);
          for (const [dot, [, y]] of Object.entries(handles).filter(([name]) => /^[xy][12]$/.test(name))) {
            assert.ok(y > 46 && y < 0.5 * 844 + 46, `${dot} at ${y}`);
          }
          await app.shot(`phone-sheet-${tab.source.slice(1, 5)}`);
          await app.walkTo(tab);
          await app.press('Space');
          await app.atRest('it is closed', (stats, y) => stats.handles.x2[1] === y, closed.handles.x2[1]);
        }
      },
      { device: 'phone' },
    ),
  );

  for (const [name, options] of Object.entries({ upright: { device: 'phone' }, lying: LYING })) {
    test(
      `undo and redo are in the bar of a phone that is ${name}`,
      bench.withApp(async (app) => {
        const { handles } = await app.stats();
        await app.touchDrag(handles.x1, [handles.x1[0] + 12, handles.x1[1] - 14]);
        await app.until('it is a step', (stats) => stats.ready && stats.undo === 1);
        const moved = await app.session();
        await app.walkTo(/^Undo, button/, 12);
        await app.press('Space');
        await app.until('it is taken back', (stats) => stats.ready && stats.undo === 0);
        await app.walkTo(/^Redo, button/, 12);
        await app.press('Space');
        await app.until('it is made again', (stats) => stats.ready && stats.undo === 1);
        assert.deepEqual(await app.session(), moved);
      }, options),
    );
  }
});
