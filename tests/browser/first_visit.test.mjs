// The first visit: the welcome, the folded controls, the share window, and what the next visit remembers.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { withOneBackend } from './backends.mjs';

/** Whether a control is among those that the Tab key reaches. */
async function has(app, control) {
  return app.walkTo(control).then(() => true, () => false);
}

withOneBackend('first-visit', (bench) => {
  test(
    'the welcome leads into the tour and does not come back',
    bench.withApp(async (app) => {
      await app.picture('welcome');
      await app.walkTo(/^Take the tour, button/);
      await app.press('Space');
      await app.saying('state', /Step|shapes/i);
      await app.walkTo(/^End, button/);
      await app.press('Space');
      await app.reload();
      assert.equal(await has(app, /^Take the tour, button/), false);
    }),
  );

  test(
    'unfolded controls stay unfolded, and their terms are explained by the keyboard',
    bench.withApp(async (app) => {
      await app.unfoldAdvanced();
      await app.reload();
      await app.walkTo(/^\? Kernel: The kernel says how much each piece/);
      await app.press('Space');
      await app.picture('kernel-explained');
      await app.walkTo(/^Advanced, button, selected/);
    }),
  );

  test(
    'the link is shared as a code, and a link that is too long says so',
    bench.withApp(async (app) => {
      await app.walkTo(/^Share, button/);
      await app.press('Space');
      const { share } = await app.until('the link is shown', (stats) => stats.share);
      assert.ok(share.bytes < 2953 && share.modules > 25, JSON.stringify(share));
      await app.picture('share');
      const { source } = await app.session();
      const points = Array.from({ length: 1500 }, (_, k) => {
        const [angle, radius] = [(2 * Math.PI * k) / 1500, 1 + 0.3 * Math.sin(k * k)];
        return [radius * Math.cos(angle), radius * Math.sin(angle)];
      });
      await app.openSession({ source: { ...source, outline: { points: { name: 'rough', points } } } });
      const long = await app.until('the link is longer', (stats, before) => stats.share?.bytes > before && stats.share, share.bytes);
      if (long.share.bytes > 2953) assert.equal(long.share.modules, null);
      await app.picture('share-long');
      await app.press('Escape');
      await app.until('the window is closed', (stats) => stats.share === null);
    }),
  );

  test(
    'a traced outline stands upright, and a picture opened as an outline is traced',
    bench.withApp(async (app) => {
      await app.loadOutline('source', 'house.csv', '2,0\n2,2\n1,3\n0,2\n0,0\n');
      const isThere = (stats) => stats.ready && stats.source.m > 0;
      await app.until('the house is prepared', isThere);
      await app.until('its outline is taken', (stats) => stats.ready);
      const { source, anchor } = await app.session();
      assert.ok(source.outline.points, JSON.stringify(source.outline));
      const rim = 6 + 2 * Math.SQRT2;
      assert.ok(Math.abs(anchor[0] - (2 + Math.SQRT2) / rim) < 1e-9, `${anchor[0]}`);
      const { handles } = await app.stats();
      assert.ok(handles.y1[1] < handles.x1[1], 'the boundary point is above the interior point');
    }),
  );
});
