// Map projections: the island by formula, a file that is offered when it is opened as an outline, and one that is refused.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { withOneBackend } from './backends.mjs';

const isMade = (stats) => stats.projection?.scale_ratio > 1;

/** A box of 20° × 10° at 45° north, and a smaller one. */
const BOXES = JSON.stringify({
  type: 'MultiPolygon',
  coordinates: [
    [[[0, 40], [20, 40], [20, 50], [0, 50], [0, 40]]],
    [[[30, 40], [31, 40], [31, 41], [30, 41], [30, 40]]],
  ],
});

withOneBackend('projection', (bench) => {
  test(
    'the island is mapped with less distortion than stereographically, and saved',
    bench.withApp(async (app) => {
      await app.walkTo(/^File, button/);
      await app.press('Enter');
      await app.walkTo(/^Map projection… , button/);
      await app.press('Enter');
      await app.until('the window is there', (stats) => stats.projection);
      await app.walkTo(/^Show an island, button/);
      await app.press('Space');
      const { projection } = await app.atRest('the island is mapped', isMade);
      assert.ok(projection.scale_ratio < projection.stereographic_scale_ratio - 1e-3, JSON.stringify(projection));
      assert.ok(projection.scale_lines > 0);
      await app.shot(`${bench.backend}-projection`);
      await app.saying('state', /Map projection of Island: scale ratio 1\.\d+, stereographic 1\.\d+\./);
      await app.walkTo(/^Save the map as SVG, button/);
      const { name, bytes } = await app.downloadBy('Space');
      assert.equal(name, 'island_projection.svg');
      assert.match(bytes.toString(), /^<svg[\s\S]*class="graticule"[\s\S]*<\/svg>\n$/);
      await app.press('Escape');
      await app.until('the window is closed', (stats) => stats.projection === null);
    }),
  );

  test(
    'a file of longitudes and latitudes that is opened as an outline is offered as a map',
    bench.withApp(async (app) => {
      const { x1 } = (await app.stats()).handles;
      await app.dropFile(x1, 'boxes.geojson', BOXES);
      await app.walkTo(/^Show as a map, button/);
      await app.press('Space');
      const { projection } = await app.atRest('the larger box is mapped', isMade);
      assert.ok(Math.abs(projection.scale_ratio - 1.00297) < 1e-5, `${projection.scale_ratio}`);
      assert.match(projection.notes[0], /one other boundary was left out/);
      assert.equal((await app.session()).source.outline.points.name, 'boxes', 'it is the outline, too');
    }),
  );
});
