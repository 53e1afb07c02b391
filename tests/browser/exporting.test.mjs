// Files exported in a browser, and animation of the points.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { withEachBackend, withOneBackend } from './backends.mjs';

/** The position of a control of the export window, by its text. */
async function placeOf(app, name) {
  const { export: places } = await app.atRest(`there is "${name}"`, (stats, wanted) => stats.export?.[wanted], name);
  return places[name];
}

/** Opens the export window and chooses an option. */
async function choose(app, ...names) {
  if ((await app.stats()).export === null) await app.press('Control+e');
  for (const name of names) await app.click(await placeOf(app, name));
}

/** Saves with the chosen options and returns the file. */
async function saved(app, ...names) {
  await choose(app, ...names);
  return app.download(await placeOf(app, 'Save'));
}

/** Two quadrilaterals with a material. */
const QUADS = 'mtllib oak.mtl\nusemtl oak\nv 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nf 1 2 5 4\nf 2 3 6 5';

/** The chunks of a PNG, by type. */
function chunksOf(png) {
  assert.equal(png.subarray(1, 4).toString(), 'PNG');
  const chunks = [];
  for (let at = 8; at < png.length; at += 12 + png.readUInt32BE(at)) {
    const length = png.readUInt32BE(at);
    chunks.push({ type: png.subarray(at + 4, at + 8).toString(), content: png.subarray(at + 8, at + 8 + length) });
  }
  return chunks;
}

function sizeOf(png) {
  const [{ content }] = chunksOf(png);
  return [content.readUInt32BE(0), content.readUInt32BE(4)];
}

/** r(z) of a function of a formula's file: Σ wₖ fₖ/(z − zₖ) / Σ wₖ/(z − zₖ). */
function formulaAt({ support_points: support, values, weights }, [x, y]) {
  const times = ([a, b], [c, d]) => [a * c - b * d, a * d + b * c];
  const over = (u, [c, d]) => times(u, [c / (c * c + d * d), -d / (c * c + d * d)]);
  const sums = [[0, 0], [0, 0]];
  for (const [k, [a, b]] of support.entries()) {
    const term = over(weights[k], [x - a, y - b]);
    const terms = [times(term, values[k]), term];
    sums.forEach((sum, j) => [0, 1].forEach((axis) => (sum[axis] += terms[j][axis])));
  }
  return over(sums[0], sums[1]);
}

withEachBackend('exports and motion', (bench) => {
  const { backend } = bench;

  test(
    'a planar map is saved in every format',
    bench.withApp(async (app) => {
      const { name, bytes } = await saved(app, 'PNG', 'Transparent');
      assert.equal(name, 'riemap.png');
      assert.deepEqual(sizeOf(bytes), [1600, 900], 'larger than the viewports on the screen');
      const pixels = await app.pixelsOf(bytes, [[0, 0], [400, 450], [1200, 450]]);
      assert.equal(pixels[0][3], 0, 'there is no ground');
      assert.deepEqual([pixels[1][3], pixels[2][3]], [255, 255], 'both domains are there');
      const bare = await saved(app, 'PNG', 'Interior and boundary point');
      assert.notDeepEqual(bare.bytes, bytes, 'without the dots');
      const svg = (await saved(app, 'SVG')).bytes.toString();
      assert.match(svg, /^<svg/);
      assert.equal(svg.match(/class="outline"/g).length, 2);
      const csv = (await saved(app, 'CSV')).bytes.toString().trim().split('\n');
      const { target, triangles } = await app.stats();
      assert.ok(csv.length > target.m + 1, `${csv.length}: a line for each sample of the refined mapped side`);
      const [head, ...rows] = csv.map((line) => line.split(','));
      const column = head.findIndex((title) => title.startsWith('harmonic measure'));
      const measures = rows.map((row) => Number(row[column]));
      assert.ok(measures.every((value, k) => k === 0 || value >= measures[k - 1]), 'harmonic measure grows');
      const obj = (await saved(app, 'OBJ')).bytes.toString();
      assert.ok(triangles > target.triangles, `${triangles}: it is refined`);
      assert.equal(obj.match(/^f /gm).length, triangles);
    }),
  );

  test(
    'an animation is made, while another one is given up',
    bench.withApp(async (app) => {
      await app.openSession({ texture_scale: 6 });
      await app.until('the map is there', (stats) => stats.ready);
      await choose(app, 'Animated PNG', '800 × 450');
      // too many to be finished before the export is cancelled
      await app.type(await placeOf(app, 'Pictures'), '400');
      await choose(app, 'Save');
      const busy = await app.until('some pictures are made', (stats) => stats.export_count?.[0] >= 2);
      assert.equal(busy.export_count[1], 400);
      await app.shot(`${backend}-export-progress`);
      await choose(app, 'Cancel');
      await app.until('it is given up', (stats) => stats.export_count === null);
      await app.type(await placeOf(app, 'Pictures'), '4');
      const before = await app.session();
      const { name, bytes } = await saved(app);
      assert.equal(name, 'riemap-animation.png');
      const chunks = chunksOf(bytes);
      assert.deepEqual(sizeOf(bytes), [800, 450]);
      assert.equal(chunks.filter(({ type }) => type === 'fcTL').length, 4);
      const pictures = chunks.filter(({ type }) => type === 'fdAT').map(({ content }) => content.subarray(4).toString('base64'));
      assert.equal(new Set(pictures).size, pictures.length, 'every picture is another one');
      assert.deepEqual(await app.session(), before, 'what is on the screen stays');
      const gif = await saved(app, 'GIF', 'x₁');
      assert.equal(gif.name, 'riemap-animation.gif');
      assert.equal(gif.bytes.subarray(0, 6).toString(), 'GIF89a');
    }),
  );

  test(
    'a surface is saved with its texture coordinates, and as it is seen',
    bench.withApp(async (app) => {
      const shape = { preset: { preset: 'hemisphere', boundary: 80 } };
      await app.openSession({ surface: { spec: { shape } } });
      const { target } = await app.until('the surface is there', (stats) => stats.ready && stats.target.m === 80);
      const obj = await saved(app, 'OBJ', 'Unit box');
      assert.equal(obj.name, 'hemisphere-mapped.obj');
      const lines = obj.bytes.toString().split('\n');
      const count = (start) => lines.filter((line) => line.startsWith(start)).length;
      assert.deepEqual(['v ', 'vt ', 'f '].map(count), [target.m + target.n, target.m + target.n, target.triangles]);
      for (const line of lines.filter((text) => text.startsWith('vt '))) {
        const [u, v] = line.slice(3).split(' ').map(Number);
        assert.ok(u >= 0 && u <= 1 && v >= 0 && v <= 1, `in the unit box: ${line}`);
      }
      assert.equal((await saved(app, 'GLB')).bytes.subarray(0, 4).toString(), 'glTF');
      const { bytes } = await saved(app, 'PNG', 'Target', 'Transparent');
      const pixels = await app.pixelsOf(bytes, [[0, 0], [800, 450]]);
      assert.deepEqual([pixels[0][3], pixels[1][3]], [0, 255]);
    }),
  );

  test(
    'a surface from a file is saved with what else is in the file',
    bench.withApp(async (app) => {
      await app.dropFile((await app.stats()).handles.x2, 'quads.obj', QUADS);
      await app.atRest('the surface is there', (stats) => stats.ready && stats.target.m === 6);
      const { name, bytes } = await saved(app, 'OBJ', 'Unit box');
      assert.equal(name, 'quads-mapped.obj');
      const lines = bytes.toString().split('\n');
      const kept = QUADS.split('\n').filter((line) => !line.startsWith('f '));
      assert.deepEqual(lines.filter((line) => kept.includes(line)), kept);
      assert.ok(lines.filter((line) => line.startsWith('vt ')).length >= 6);
    }),
  );
});

withOneBackend('formulas, a phone, and motion', (bench) => {
  test(
    'the map is saved as a formula, while another one is given up',
    bench.withApp(async (app) => {
      const { source, target } = await app.session();
      const settings = (side) => ({ ...side.settings, sampling: { adaptive: { target: 200 } } });
      await app.openSession({
        source: { ...source, outline: { preset: 'blob' }, settings: settings(source) },
        target: { ...target, outline: { preset: 'disk' }, settings: settings(target) },
        direction: 'forward',
        anchor: [0.2, 0.6],
      });
      await app.until('both sides are sharp', (stats) => stats.ready && stats.error_estimate !== null);
      const [{ bytes: table }, generation] = [await saved(app, 'CSV'), (await app.stats()).generation];
      await choose(app, 'Formula', 'JSON');
      await app.type(await placeOf(app, 'Digits'), '12');
      await choose(app, 'Save');
      const { formula } = await app.until('it is at work', (stats) => stats.formula.progress > 0);
      assert.ok(formula.progress < 1 && formula.reached.length === 0);
      await app.shot('formula-progress');
      await choose(app, 'Cancel');
      await app.until('it is given up', (stats) => stats.formula.progress === null);
      await app.type(await placeOf(app, 'Digits'), '6');
      const { name, bytes } = await saved(app);
      assert.equal(name, 'riemap_formula.json');
      const file = JSON.parse(bytes.toString());
      assert.deepEqual([file.source, file.target, file.digits], ['preset:blob', 'preset:disk', 6]);
      assert.ok(file.digits_reached >= 6 && file.f.poles.length <= file.f.degree, bytes.toString().slice(0, 500));
      const rows = table.toString().trim().split('\n').slice(1).map((row) => row.split(',').map(Number));
      const off = rows.map(([, , x, y, u, v]) => {
        const [image, back] = [formulaAt(file.f, [x, y]), formulaAt(file.inverse, [u, v])];
        return Math.max(Math.hypot(image[0] - u, image[1] - v) / 1, Math.hypot(back[0] - x, back[1] - y) / 5);
      });
      // six digits of the extent, and an image of the table is that of the curve beside the sample
      assert.ok(rows.length > 100 && Math.max(...off) < 1e-5, `off by ${Math.max(...off)} at ${rows.length} points`);
      const { formula: { reached } } = await app.until('it says what it reached', (stats) => stats.formula.reached.length > 2);
      assert.match(reached[1], /^f: degree \d+; poles: \d+, none inside; largest error: .*e-\d+; digits: [6-9]/);
      await app.saying('state', /inverse of f: degree \d+/);
      await app.shot('formula');
      assert.equal((await saved(app, 'GLSL')).name, 'riemap_formula.glsl');
      assert.equal((await app.stats()).generation, generation, 'the map on the screen stays');
    }),
  );

  test(
    'a picture is saved on a phone',
    bench.withApp(
      async (app) => {
        await choose(app, 'PNG');
        await app.shot('export-phone');
        const { bytes } = await saved(app, '800 × 450');
        assert.deepEqual(sizeOf(bytes), [800, 450]);
        await choose(app, 'Formula', 'Python');
        await app.type(await placeOf(app, 'Digits'), '2');
        assert.match((await saved(app)).bytes.toString(), /^# A conformal map f(.|\n)*maps "preset:/);
        await app.shot('formula-phone');
      },
      { device: 'phone' },
    ),
  );

  test(
    'space plays and pauses, the points stay, and one step takes it back',
    bench.withApp(async (app) => {
      const [start, address] = [await app.session(), await app.otherAddress(bench.address())];
      const { handles, generation } = await app.stats();
      await app.press('Space');
      await app.until(
        'the boundary point moves, and the map with it',
        (stats, { y1, last }) => stats.playing && stats.generation > last + 3 && Math.hypot(stats.handles.y1[0] - y1[0], stats.handles.y1[1] - y1[1]) > 5,
        { y1: handles.y1, last: generation },
      );
      assert.equal(app.address(), address, 'the address waits until it rests');
      await app.press('Space');
      await app.until('it is one step', (stats) => !stats.playing && stats.ready && stats.undo === 1);
      const there = await app.session();
      assert.notDeepEqual(there.anchor, start.anchor);
      await app.atRest();
      assert.deepEqual(await app.session(), there);
      await app.press('Control+z');
      await app.until('it is taken back', (stats) => stats.ready && stats.undo === 0);
      assert.deepEqual(await app.session(), start);
    }),
  );
});
