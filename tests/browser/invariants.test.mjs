// The panel of invariants, by keyboard, in a real browser.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { withOneBackend } from './backends.mjs';

withOneBackend('invariants', (bench) => {
  test(
    'the invariants of a side are computed at rest, said, and renewed when its point moves',
    bench.withApp(async (app) => {
      const { source } = await app.session();
      await app.openSession({ source: { ...source, outline: { preset: 'disk' } } });
      await app.atRest('the disk is shown');
      await app.unfoldAdvanced();
      await app.walkTo(/^Invariants · source, check box, not selected/i);
      await app.press('Space');
      const there = (stats) => stats.ready && stats.invariants[0]?.Ok;
      const { invariants } = await app.until('the invariants of the source are there', there);
      const { capacity, conformal_radius: radius } = invariants[0].Ok;
      assert.ok(Math.abs(capacity.value - 1) <= capacity.error + 1e-13, `the disk's capacity is ${capacity.value}`);
      assert.ok(radius.value > 0.9 && radius.value <= 1 + 1e-12, `the conformal radius is ${radius.value}`);
      await app.saying('state', /Invariants · [Ss]ource: Conformal radius: /);
      const { x1 } = (await app.stats()).handles;
      await app.drag(x1, [x1[0] + 40, x1[1]]);
      const smaller = (stats, before) => stats.ready && stats.invariants[0]?.Ok?.conformal_radius.value < before - 1e-3;
      await app.until('the radius at the new point is smaller', smaller, radius.value);
      await app.shot(`${bench.backend}-invariants`);
    }),
  );
});
