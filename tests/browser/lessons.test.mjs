// Lessons: made in their panel, kept through a reload, saved, copied as a link, and played; and the tour without motion.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { withOneBackend } from './backends.mjs';

/** Opens the panel. */
async function openPanel(app) {
  await app.walkTo(/^File, button/);
  await app.press('Space');
  await app.walkTo(/^Make a lesson… , button/);
  await app.press('Enter');
}

/** Walks to a control, and uses it. */
async function use(app, control) {
  await app.walkTo(control);
  await app.press('Enter');
}

/** Adds the present picture as a step with this caption, the step's number from 1. */
async function addStep(app, number, caption) {
  await use(app, /^Add step, button/);
  await app.walkTo(new RegExp(`^Caption of step ${number}`, 'u'));
  await app.page.keyboard.type(caption);
}

/** Makes a lesson of two pictures; the second one stays on the screen. */
async function makeLesson(app) {
  await openPanel(app);
  await app.walkTo(/^Title/);
  await app.page.keyboard.type('Two scales');
  await app.openSession({ texture_scale: 9 });
  await app.until('the first picture', (stats) => stats.ready);
  await addStep(app, 1, 'Wide squares');
  await app.openSession({ texture_scale: 33 });
  await app.until('the second picture', (stats) => stats.ready);
  await addStep(app, 2, 'Fine squares');
}

const scaleOf = async (app) => (await app.session()).texture_scale;

withOneBackend('lessons', (bench) => {
  test(
    'a lesson is made, kept, saved, and played by its link, and gives the own picture back',
    bench.withApp(async (app) => {
      await app.page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
      const first = await app.otherAddress(bench.address());
      await makeLesson(app);
      await app.shot(`${bench.backend}-making-a-lesson`);
      await app.openSession({ texture_scale: 13 });
      await app.until('the own picture', (stats) => stats.ready);
      await app.otherAddress(first);
      const mine = await app.session();
      await app.reload();
      await openPanel(app);
      await app.walkTo(/^Save…, button/);
      const saved = await app.downloadBy('Enter');
      const text = saved.bytes.toString();
      assert.equal(saved.name, 'lesson.txt');
      assert.match(text, /^riemap lesson 1\nTitle: Two scales\n\nhttp.*#s=.*\nWide squares\n\nhttp.*#s=.*\nFine squares\n$/u);
      await use(app, /^Copy link, button/);
      const link = await app.page.evaluate(() => navigator.clipboard.readText());
      assert.match(link, /#lesson=1\./);
      await app.page.goto('about:blank');
      await app.page.goto(link);
      await app.atRest('the lesson is shown');
      for (let time = 0; time < 2; time++) {
        await app.saying('state', /Two scales Wide squares/);
        await app.reload();
      }
      assert.equal(await scaleOf(app), 9);
      await app.saying('state', /Wide squares/);
      await app.shot(`${bench.backend}-a-lesson`);
      await use(app, /^Next, button/);
      await app.saying('state', /Fine squares/);
      assert.equal(await scaleOf(app), 33);
      await app.press('Escape');
      await app.until('the own picture is back', (stats) => stats.ready);
      assert.deepEqual(await app.session(), mine);
      await app.otherAddress(link);
      await app.reload();
      assert.deepEqual(await app.session(), mine, 'also after a reload');
    }),
  );

  test(
    'back from a lesson shows the own picture, and forward plays the lesson again',
    bench.withApp(async (app) => {
      await app.page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
      await makeLesson(app);
      await use(app, /^Copy link, button/);
      const link = await app.page.evaluate(() => navigator.clipboard.readText());
      const mine = await app.session();
      await app.paste(new URL(link).hash);
      await app.saying('state', /Wide squares/);
      await app.page.goBack();
      await app.until('the own picture is back', (stats) => stats.ready && window.riemap.session().texture_scale === 33);
      await app.page.goForward();
      await app.saying('state', /Wide squares/);
      await app.press('Escape');
      await app.until('the own picture again', (stats) => stats.ready && window.riemap.session().texture_scale === 33);
      assert.deepEqual(await app.session(), mine);
    }),
  );

  test(
    'a dropped lesson is played, and one that cannot be read says where',
    bench.withApp(async (app) => {
      const address = await app.otherAddress(bench.address());
      const mine = await app.session();
      const { handles } = await app.stats();
      const lesson = `riemap lesson 1\r\nTitle: By hand\r\n\r\n${address}\r\nWritten in an editor.\r\n`;
      await app.dropFile(handles.x1, 'class.txt', lesson.replace('#s=1.', '#s=1.A'));
      await app.until('the line is named', (stats) => stats.errors.some((error) => error.includes('step 1 (line 4)')));
      await app.dropFile(handles.x1, 'class.txt', lesson);
      await app.saying('state', /By hand Written in an editor\./);
      await app.until('the message is gone', (stats) => stats.errors.length === 0);
      await app.press('Escape');
      assert.deepEqual(await app.session(), mine);
    }),
  );

  test(
    'where less motion is wanted, the tour moves a point only when it is asked to',
    bench.withApp(
      async (app) => {
        await use(app, /^Take the tour, button/);
        await app.until('the first step is shown', (stats) => stats.ready);
        const { generation } = await app.atRest('nothing moves');
        await use(app, /^Show, button/);
        await app.until('the point moves', (stats, before) => stats.playing && stats.generation > before, generation);
      },
      { reducedMotion: 'reduce' },
    ),
  );
});
