// Files that hold more than one shape, and shapes that are more than one file.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { withOneBackend } from './backends.mjs';

/** A house with a window, a smaller tree, and a sun without a name. */
const DRAWING = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100">
  <path id="house" d="M10 90V50L35 25L60 50V90Z M25 60H45V75H25Z"/>
  <path id="tree" d="M75 90V70L65 70L77 40L90 70H80V90Z"/><circle cx="80" cy="18" r="8"/></svg>`;

const feature = (name, x, size) => ({
  type: 'Feature',
  properties: { name },
  geometry: { type: 'Polygon', coordinates: [[[x, 40], [x + size, 40], [x + size, 40 + size], [x, 40 + size], [x, 40]]] },
});

const LANDS = JSON.stringify({ type: 'FeatureCollection', features: [feature('Great', 0, 9), feature('Small', 20, 3)] });

const name = async (app) => (await app.session()).source.outline.points?.name;

/** A glTF document of a square whose corners are in a file beside it. */
function square() {
  const corners = new Float32Array([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]);
  const triangles = new Uint16Array([0, 1, 2, 0, 2, 3]);
  const document = {
    asset: { version: '2.0' },
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    accessors: [
      { bufferView: 0, componentType: 5126, count: 4, type: 'VEC3' },
      { bufferView: 1, componentType: 5123, count: 6, type: 'SCALAR' },
    ],
    bufferViews: [{ buffer: 0, byteLength: 48 }, { buffer: 0, byteOffset: 48, byteLength: 12 }],
    buffers: [{ byteLength: 60, uri: 'square.bin' }],
  };
  const buffer = Buffer.concat([Buffer.from(corners.buffer), Buffer.from(triangles.buffer)]);
  return { 'square.bin': buffer, 'square.gltf': Buffer.from(JSON.stringify(document)) };
}

withOneBackend('files', (bench) => {
  for (const device of ['desktop', 'phone']) {
    test(
      `another shape of a drawing is picked from small pictures on a ${device}`,
      bench.withApp(async (app) => {
        const { x1 } = (await app.stats()).handles;
        await app.dropFile(x1, 'scene.svg', DRAWING);
        await app.until('the outline is read', (stats) => stats.undo === 1);
        await app.shot(`${bench.backend}-${device}-shapes-offered`);
        await app.atRest('the largest shape is the outline', (stats) => stats.ready && stats.undo === 1);
        assert.equal(await name(app), 'house');
        await app.walkTo(device === 'phone' ? /^Source, button/ : /^Shapes, button/);
        await app.press('Space');
        await app.walkTo(/^tree, button, not selected/);
        await app.shot(`${bench.backend}-${device}-shapes-of-a-drawing`);
        await app.press('Space');
        await app.atRest('the tree is the outline', (stats) => stats.ready && stats.undo === 2);
        assert.equal(await name(app), 'tree');
      }, device === 'phone' ? { device } : {}),
    );
  }

  test(
    'the features of a map are listed by name, as outlines and for a projection',
    bench.withApp(async (app) => {
      const { x1 } = (await app.stats()).handles;
      await app.dropFile(x1, 'lands.geojson', LANDS);
      await app.atRest('the larger one is the outline', (stats) => stats.ready && stats.undo === 1);
      await app.walkTo(/^Shapes, button/);
      await app.press('Space');
      await app.walkTo(/^Small, button, not selected/);
      await app.press('Space');
      await app.atRest('the smaller one is the outline', (stats) => stats.ready && stats.undo === 2);
      assert.equal(await name(app), 'Small');
      await app.walkTo(/^Show as a map, button/);
      await app.press('Space');
      const of = (land) => new RegExp(`Map projection of ${land}: scale ratio 1`);
      await app.saying('state', of('Small'));
      await app.walkTo(/^Feature, button/);
      await app.press('Space');
      await app.walkTo(/^Great, /);
      await app.shot(`${bench.backend}-features-of-a-map`);
      await app.press('Space');
      await app.saying('state', of('Great'));
    }),
  );

  test(
    'a glTF document is dropped together with its buffer',
    bench.withApp(async (app) => {
      const { x1 } = (await app.stats()).handles;
      await app.dropFiles(x1, square());
      const { source } = await app.atRest('the square is there', (stats) => stats.ready && stats.undo === 1);
      assert.equal(source.m, 4);
      assert.match(JSON.stringify(await app.session()), /square\.gltf/);
    }),
  );
});
