// The first visit: the welcome, the folded controls, the share window, and what the next visit remembers.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { withOneBackend } from './backends.mjs';

/** Whether a control is among those that the Tab key reaches. */
async function has(app, control) {
  return app.walkTo(control).then(() => true, () => false);
}

/** Runs in the page before its scripts: the system's dialog takes what is shared, and is closed without a choice. */
function withSharing() {
  const share = (given) => {
    window.shared = given;
    return Promise.reject(new DOMException('closed', 'AbortError'));
  };
  Object.defineProperty(Navigator.prototype, 'share', { value: share, configurable: true });
}

/** Runs in the page before its scripts: the system has no such dialog. */
function withoutSharing() {
  delete Navigator.prototype.share;
}

withOneBackend('first-visit', (bench) => {
  test(
    'the welcome leads into the tour and does not come back',
    bench.withApp(async (app) => {
      await app.shot('welcome');
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
      await app.shot('kernel-explained');
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
      await app.shot('share');
      const { source } = await app.session();
      const points = Array.from({ length: 1500 }, (_, k) => {
        const [angle, radius] = [(2 * Math.PI * k) / 1500, 1 + 0.3 * Math.sin(k * k)];
        return [radius * Math.cos(angle), radius * Math.sin(angle)];
      });
      await app.openSession({ source: { ...source, outline: { points: { name: 'rough', points } } } });
      const long = await app.until('the link is longer', (stats, before) => stats.share?.bytes > before && stats.share, share.bytes);
      if (long.share.bytes > 2953) assert.equal(long.share.modules, null);
      await app.shot('share-long');
      await app.press('Escape');
      await app.until('the window is closed', (stats) => stats.share === null);
    }),
  );

  test(
    'the system shares title and link; where it has no dialog there is the code and the copy',
    bench.withApp(
      async (app) => {
        await app.walkTo(/^Share, button/);
        await app.press('Space');
        await app.until('the link is shown', (stats) => stats.share);
        await app.walkTo(/^Share…, button/);
        await app.press('Space');
        const given = await (await app.page.waitForFunction(() => window.shared)).jsonValue();
        assert.deepEqual(given, { title: await app.page.title(), url: `${bench.address()}${await app.page.evaluate(() => window.riemap.link())}` });
        assert.deepEqual((await app.stats()).errors, [], 'that the dialog was closed is no error');

        const other = await bench.open(bench.address(), { prepare: withoutSharing });
        await other.during(async () => {
          await other.walkTo(/^Share, button/);
          await other.press('Space');
          const { share } = await other.until('the link is shown', (stats) => stats.share);
          assert.ok(share.modules > 25);
          await other.walkTo(/^Copy link, button/);
          await assert.rejects(other.walkTo(/^Share…, button/, 70), /no control/);
        });
      },
      { prepare: withSharing },
    ),
  );

  test(
    'an outline stands upright',
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

  test(
    'a picture opened as an outline is traced if that is the answer',
    bench.withApp(async (app) => {
      const picture = Buffer.from(await app.page.evaluate(boxPicture), 'base64');
      const { source } = await app.session();
      await app.loadFile('source', 'box.png', picture);
      await app.walkTo(/^Cancel, button/);
      await app.shot('picture-asked');
      assert.deepEqual((await app.session()).source, source, 'nothing changes before the answer');
      await app.press('Space');
      await app.loadFile('source', 'box.png', picture);
      await app.walkTo(/^Use as pattern, button/);
      await app.press('Space');
      await app.until('the picture is the pattern', (stats) => stats.image === 'box.png');
      assert.deepEqual((await app.session()).source, source);
      await app.loadFile('source', 'box.png', picture);
      await app.walkTo(/^Trace its silhouette, button/);
      await app.press('Space');
      await app.atRest('the silhouette is the outline', (stats) => stats.ready && stats.source.m > 0);
      assert.equal((await app.session()).source.outline.points.name, 'box');
    }),
  );
});

/** Runs in the page: a black box on white as PNG, in base64. */
async function boxPicture() {
  const picture = new OffscreenCanvas(300, 240);
  const context = picture.getContext('2d');
  context.fillStyle = 'white';
  context.fillRect(0, 0, 300, 240);
  context.fillStyle = 'black';
  context.fillRect(60, 90, 120, 60);
  const bytes = new Uint8Array(await (await picture.convertToBlob()).arrayBuffer());
  return btoa(String.fromCharCode(...bytes));
}
