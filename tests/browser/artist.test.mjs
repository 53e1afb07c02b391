// What a texture artist needs: exports that hit the corners and contain the picture, the texture coordinates' grid.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { withOneBackend } from './backends.mjs';

/** Runs in the page: drops a picture on the source. */
async function dropPicture() {
  const picture = new OffscreenCanvas(64, 48);
  const context = picture.getContext('2d');
  context.fillStyle = 'rgb(200, 40, 160)';
  context.fillRect(8, 8, 30, 20);
  const dataTransfer = new DataTransfer();
  dataTransfer.items.add(new File([await picture.convertToBlob()], 'own.png'));
  const canvas = document.querySelector('canvas');
  for (const type of ['dragenter', 'dragover', 'drop']) {
    canvas.dispatchEvent(new DragEvent(type, { bubbles: true, cancelable: true, clientX: 500, clientY: 400, dataTransfer }));
  }
}

/** Shows half a sphere over a square. */
async function overSquare(app, changes = {}) {
  const { source } = await app.session();
  const shape = { preset: { preset: 'hemisphere', boundary: 80 } };
  await app.openSession({ source: { ...source, outline: { preset: 'square' } }, surface: { spec: { shape } }, ...changes });
  return app.atRest('the surface is there', (stats) => stats.ready && stats.target.m === 80);
}

/** Screenshots after which a picture that is still another one is taken for final. */
const MOST_SHOTS = 40;

/** Saves with a choice in the window of exports. */
async function saved(app, ...names) {
  if ((await app.stats()).export === null) await app.press('Control+e');
  for (const name of [...names, 'Save']) {
    const { export: places } = await app.atRest(`there is "${name}"`, (stats, wanted) => stats.export?.[wanted], name);
    if (name === 'Save') return app.download(places[name]);
    await app.click(places[name]);
  }
  return null;
}

/** The texture coordinates of an OBJ, and how many lie at a corner of [0, 1]² to the bit. */
function cornersOf(obj) {
  const places = obj.toString().match(/^vt .*$/gm).map((line) => line.slice(3).split(' ').map(Number));
  return [places, places.filter((place) => place.every((value) => value === 0 || value === 1)).length];
}

/** The document and the binary chunk of a GLB. */
function chunksOf(glb) {
  assert.equal(glb.subarray(0, 4).toString(), 'glTF');
  const length = glb.readUInt32LE(12);
  return [JSON.parse(glb.subarray(20, 20 + length).toString()), glb.subarray(28 + length)];
}

withOneBackend('the artist', (bench) => {
  test(
    'a layout hits the corners of the square to the bit, or keeps the vertices of the surface',
    bench.withApp(async (app) => {
      const { target } = await overSquare(app);
      const [hit, corners] = cornersOf((await saved(app, 'OBJ', 'Unit box')).bytes);
      assert.equal(corners, 4);
      assert.ok(hit.length > target.m + target.n, 'edges are divided there');
      const [free, none] = cornersOf((await saved(app, 'Hit exactly')).bytes);
      assert.deepEqual([none, free.length], [0, target.m + target.n], 'the vertices of the surface alone');
    }),
  );

  test(
    'a GLB has normals and coordinates, and the own picture as its base color',
    bench.withApp(async (app) => {
      await overSquare(app);
      await app.page.evaluate(dropPicture);
      await app.atRest('the picture is the texture', (stats) => stats.ready && stats.image === 'own.png');
      const [document, bytes] = chunksOf((await saved(app, 'GLB')).bytes);
      const { attributes, material } = document.meshes[0].primitives[0];
      const { index, texCoord = 0 } = document.materials[material].pbrMetallicRoughness.baseColorTexture;
      // the layout in the outline, and the place in the picture
      assert.deepEqual(Object.keys(attributes).sort(), ['NORMAL', 'POSITION', 'TEXCOORD_0', 'TEXCOORD_1']);
      assert.ok(`TEXCOORD_${texCoord}` in attributes);
      const image = document.images[document.textures[index].source];
      const view = document.bufferViews[image.bufferView];
      assert.equal(image.mimeType, 'image/png');
      assert.equal(bytes.subarray(view.byteOffset + 1, view.byteOffset + 4).toString(), 'PNG');
    }),
  );

  test(
    'the grid of the texture coordinates is drawn over the outline, and taken away again',
    bench.withApp(async (app) => {
      const { handles } = await overSquare(app, { texture: 'checker' });
      const [x, y] = handles.x1;
      // the view of the grid leaves room for its numbers
      const around = async (isFitted) => {
        const isThere = (stats, [left, top, as]) =>
          stats.ready && (Math.hypot(stats.handles.x1[0] - left, stats.handles.x1[1] - top) < 0.5) === as;
        await app.atRest('the view fits', isThere, [x, y, isFitted]);
        return (await app.screenshot({ clip: { x: x - 150, y: y - 100, width: 300, height: 200 } })).toString('base64');
      };
      await app.walkTo(/^UV grid, check box/);
      let without = await around(true);
      for (let next = await around(true); next !== without; next = await around(true)) without = next;
      await app.press('Space');
      const drawn = await around(false);
      assert.notEqual(drawn, without);
      await app.shot('uv-grid');
      await app.press('Space');
      // what moved is first drawn with fewer pixels
      let back = await around(true);
      for (let shots = 1; shots < MOST_SHOTS && back !== without; shots++) back = await around(true);
      assert.ok(back === without, 'as before');
    }),
  );
});
