// One running app: how a person's hands and eyes reach it, in states and not in time.

import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';

import { newPage } from './chromium.mjs';
import { watch } from './faults.mjs';

const DESKTOP = { viewport: { width: 1440, height: 900 } };
const PHONE = { viewport: { width: 390, height: 844 }, deviceScaleFactor: 2, hasTouch: true, isMobile: true };
export const DEVICES = { desktop: DESKTOP, phone: PHONE };

/** What stands still for so many frames has found its place: an input shows after two at most. */
const STILL_FRAMES = 3;

/** Runs in the page before its scripts: lets frames be held back. */
function makeFramesHoldable() {
  const ask = window.requestAnimationFrame.bind(window);
  let held = null;
  window.requestAnimationFrame = (callback) => ask((time) => (held ? held.push(callback) : callback(time)));
  window.holdFrames = () => (held = []);
  window.releaseFrames = () => {
    const late = held;
    held = null;
    late.forEach((callback) => ask(callback));
  };
}

/** The app on one page. What goes wrong behind the scenes is kept, and `during` fails on it. */
export class App {
  #page;
  #backend;
  #faults;
  #waits = 0;

  /** Opens an address in a page with the `options` of its context; `prepare` runs in it before its own scripts. */
  static async open(browser, address, { backend, prepare, ...options }) {
    const page = await newPage(browser, options);
    const app = new App(page, backend);
    await page.addInitScript(makeFramesHoldable);
    if (prepare) await page.addInitScript(prepare);
    await page.goto(address);
    return app;
  }

  constructor(page, backend) {
    this.#page = page;
    this.#backend = backend;
    this.#faults = watch(page.context());
    // as long as someone listens no dialog is opened by the system; taken on and off around each use it is, at times
    page.on('filechooser', () => {});
    // after an uncaught error no state is reached any more: closing the page ends every wait
    page.on('pageerror', () => page.close());
    page.on('crash', () => {
      this.#faults.push('the page crashed');
      return page.close();
    });
  }

  /** Lets `act` use the app, then closes it; fails if anything went wrong in front of or behind the scenes. */
  async during(act) {
    try {
      const { backend } = await this.atRest('a first map is shown');
      assert.equal(backend, this.#backend);
      await act();
    } catch (error) {
      throw this.#faults.length === 0 ? error : new Error(this.#faults.join('\n'), { cause: error });
    } finally {
      await this.#page.context().close();
    }
    assert.deepEqual(this.#faults, [], 'nothing goes wrong behind the scenes');
  }

  /** The page itself, for what is not the app. */
  get page() {
    return this.#page;
  }

  stats() {
    return this.#page.evaluate(() => window.riemap.stats());
  }

  session() {
    return this.#page.evaluate(() => window.riemap.session());
  }

  /** Shows the present session with some fields changed. */
  async openSession(changes) {
    const refusal = await this.#page.evaluate(
      (changed) => window.riemap.open_session({ ...window.riemap.session(), ...changed }),
      changes,
    );
    assert.equal(refusal, null, 'the session is taken');
    await this.#frames();
  }

  /** What `riemap.open_session` says of something that is no session. */
  refusalOf(value) {
    return this.#page.evaluate((given) => window.riemap.open_session(given), value);
  }

  /** Waits until `reached(stats, argument)`, asked once a frame in the page, and returns the stats. */
  until(state, reached, argument) {
    return this.#reach(state, `return (${reached})(stats, argument) ? stats : null;`, argument);
  }

  /** As `until`; then dots and controls must have stood still, as a new view or window takes frames to find its place. */
  atRest(state, reached = (stats) => stats.ready, argument = null) {
    const wait = ++this.#waits;
    const body = `
      if (!(${reached})(stats, argument)) return null;
      const places = JSON.stringify([stats.handles, stats.editing, stats.export, stats.close]);
      const { still } = window.seen?.wait === ${wait} && window.seen.places === places ? window.seen : { still: 0 };
      window.seen = { wait: ${wait}, places, still: still + 1 };
      return still >= ${STILL_FRAMES} ? stats : null;`;
    return this.#reach(state, body, argument);
  }

  async #reach(state, body, argument) {
    // a function, as the page's policy lets no text be evaluated between the frames
    const asked = new Function('argument', `const stats = window.riemap?.stats?.(); if (!stats) return null; ${body}`);
    try {
      return await (await this.#page.waitForFunction(asked, argument ?? null)).jsonValue();
    } catch (error) {
      const last = await this.#page.evaluate(() => JSON.stringify(window.riemap?.stats?.())).catch(String);
      throw new Error(`not reached: ${state}\nlast stats: ${last}`, { cause: error });
    }
  }

  /** Animation frames: after one the app has seen what was done, after two it has drawn it. */
  #frames(count = 2) {
    const pass = (left) => new Promise((done) => {
      const next = () => (left-- > 0 ? requestAnimationFrame(next) : done());
      next();
    });
    return this.#page.evaluate(pass, count);
  }

  /** Drags with the mouse, one step a frame, as a hand would. */
  async drag(from, to, steps = 4) {
    await this.hold(from, to, steps);
    await this.letGo();
  }

  /** Moves the pointer there. */
  async pointAt(at) {
    await this.#page.mouse.move(...at);
    await this.#frames();
  }

  /** Clicks. */
  async click(at) {
    await this.pointAt(at);
    await this.#betweenFrames(() => this.#page.mouse.click(...at));
  }

  /** Presses and lets go within a frame: a press that lasts longer than 0.8 s, as slow frames can make it, is no click. */
  async #betweenFrames(press) {
    await this.#page.evaluate(() => window.holdFrames());
    await press();
    await this.#page.evaluate(() => window.releaseFrames());
    await this.#frames();
  }

  /** Drags with the mouse and does not let go. */
  async hold(from, to, steps = 4) {
    const { mouse } = this.#page;
    await this.pointAt(from);
    await mouse.down();
    await this.#frames();
    for (const point of between(from, to, steps)) {
      await mouse.move(...point);
      await this.#frames(1);
    }
    await this.#frames(1);
  }

  /** Lets go of what is held. */
  async letGo() {
    await this.#page.mouse.up();
    await this.#frames();
  }

  /** Pastes a text, as the browser does on Ctrl+V. */
  async pasteText(text) {
    await this.#page.evaluate((pasted) => {
      const clipboardData = new DataTransfer();
      clipboardData.setData('text', pasted);
      const paste = new ClipboardEvent('paste', { bubbles: true, cancelable: true, clipboardData });
      (document.activeElement ?? document.querySelector('canvas')).dispatchEvent(paste);
    }, text);
    await this.#frames();
  }

  /** Drags with one finger. */
  async touchDrag(from, to, steps = 4) {
    const protocol = await this.#page.context().newCDPSession(this.#page);
    const touch = async (type, touchPoints) => {
      await protocol.send('Input.dispatchTouchEvent', { type, touchPoints });
      await this.#frames(1);
    };
    await touch('touchStart', [{ x: from[0], y: from[1] }]);
    await this.#frames(1);
    for (const [x, y] of between(from, to, steps)) await touch('touchMove', [{ x, y }]);
    await touch('touchEnd', []);
    await this.#frames(1);
  }

  /** Taps with one finger. */
  async tap(at) {
    await this.#betweenFrames(() => this.#page.touchscreen.tap(...at));
  }

  /** Begins to drag with one finger; then the system takes the touch away, as for a gesture of its own. */
  async touchTakenAway(from, to) {
    const protocol = await this.#page.context().newCDPSession(this.#page);
    const touch = async (type, touchPoints) => {
      await protocol.send('Input.dispatchTouchEvent', { type, touchPoints });
      await this.#frames();
    };
    await touch('touchStart', [{ x: from[0], y: from[1] }]);
    await touch('touchMove', [{ x: to[0], y: to[1] }]);
    await touch('touchCancel', []);
  }

  /** Opens the browser's file dialog by `act`, and chooses a file with this text; without a name it is cancelled. */
  async inFileDialog(act, name, text = '') {
    const [chooser] = await Promise.all([this.#page.waitForEvent('filechooser'), act()]);
    if (name) await chooser.setFiles({ name, mimeType: 'application/octet-stream', buffer: Buffer.from(text) });
    else await chooser.element().dispatchEvent('cancel');
    await this.#frames();
  }

  async loadOutline(side, name, text) {
    await this.#page.evaluate((given) => window.riemap.load_outline(...given), [side, name, text]);
    await this.#frames();
  }

  /** Opens a file of any kind, given as bytes. */
  async loadFile(side, name, bytes) {
    await this.#page.evaluate(
      ([where, called, text]) => window.riemap.load_file(where, called, Uint8Array.from(atob(text), (c) => c.charCodeAt(0))),
      [side, name, bytes.toString('base64')],
    );
    await this.#frames();
  }

  /** The page's address. */
  address() {
    return this.#page.url();
  }

  /** Loads the page again, and waits for its map. */
  async reload() {
    await this.#page.reload();
    return this.atRest('a map is shown again');
  }

  /** Waits until the address has another fragment than `before`, and returns it. */
  async otherAddress(before) {
    const other = (old) => window.location.href !== old && window.location.href;
    return (await this.#page.waitForFunction(other, before)).jsonValue();
  }

  /** Goes to another fragment, as a person does who pastes a link into the address bar. */
  async paste(fragment) {
    await this.#page.evaluate((hash) => (window.location.hash = hash), fragment);
    await this.#frames();
  }

  /** Presses keys together, such as "Control+z". */
  async press(keys) {
    await this.#page.keyboard.press(keys);
    await this.#frames();
  }

  /** Walks with the Tab key until a control is said that matches, as someone does who does not see the screen. */
  async walkTo(control, furthest = 150) {
    const heard = [];
    for (let step = 0; step < furthest; step++) {
      const { spoken } = await this.stats();
      await this.#page.keyboard.press(step === 0 ? 'F6' : 'Tab');
      heard.push(await this.#saidAfter(spoken));
      if (!control.test(heard.at(-1))) continue;
      // what was said may have been said of the key before: then this one has led on by now
      await this.#frames();
      if (control.test(await this.#page.textContent('#spoken'))) return;
      await this.press('Shift+Tab');
      if (control.test(await this.#page.textContent('#spoken'))) return;
    }
    throw new Error(`no control ${control} among: ${heard.join(' | ')}`);
  }

  /** What was said last, once more than `spoken` controls have been said. */
  async #saidAfter(spoken) {
    const said = (before) => window.riemap.stats().spoken > before && { text: document.getElementById('spoken').textContent };
    return (await (await this.#page.waitForFunction(said, spoken)).jsonValue()).text;
  }

  /** Waits until the page says something that matches in one of its regions, other than `before`, and returns it. */
  async saying(region, words, before = null) {
    const says = ([id, source, old]) => {
      const text = document.getElementById(id)?.textContent ?? '';
      return text !== old && new RegExp(source, 'u').test(text) ? text : null;
    };
    try {
      return await (await this.#page.waitForFunction(says, [region, words.source, before])).jsonValue();
    } catch (error) {
      throw new Error(`not said: ${words}, but: ${await this.#page.textContent(`#${region}`)}`, { cause: error });
    }
  }

  /** The language that the page says it speaks. */
  language() {
    return this.#page.getAttribute('html', 'lang');
  }

  /** Makes the system light or dark. */
  prefer(colorScheme) {
    return this.#page.emulateMedia({ colorScheme });
  }

  /** Presses keys, and returns the file that the browser downloads then. */
  downloadBy(keys) {
    return this.#downloaded(() => this.press(keys));
  }

  /** Clicks at a place of the window, and returns the file that the browser downloads then. */
  download(at) {
    return this.#downloaded(() => this.click(at));
  }

  async #downloaded(act) {
    const [download] = await Promise.all([this.#page.waitForEvent('download'), act()]);
    const chunks = [];
    for await (const chunk of await download.createReadStream()) chunks.push(chunk);
    return { name: download.suggestedFilename(), bytes: Buffer.concat(chunks) };
  }

  /** Writes into the number at a place of the window. */
  async type(at, text) {
    await this.click(at);
    await this.press('Control+a');
    await this.#page.keyboard.type(text);
    await this.press('Enter');
  }

  /** The red, green, blue and alpha of some pixels of a PNG. */
  pixelsOf(png, places) {
    return this.#page.evaluate(
      async ([base64, wanted]) => {
        const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
        const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }), { premultiplyAlpha: 'none' });
        const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
        context.drawImage(bitmap, 0, 0);
        return wanted.map(([x, y]) => [...context.getImageData(x, y, 1, 1).data]);
      },
      [png.toString('base64'), places],
    );
  }

  /** Drops a file on the canvas at a place of the window, as from a file manager. */
  async dropFile(at, name, text) {
    await this.#page.evaluate(
      ([[clientX, clientY], fileName, content]) => {
        const dataTransfer = new DataTransfer();
        dataTransfer.items.add(new File([content], fileName));
        const canvas = document.querySelector('canvas');
        for (const type of ['dragenter', 'dragover', 'drop']) {
          canvas.dispatchEvent(
            new DragEvent(type, { bubbles: true, cancelable: true, clientX, clientY, dataTransfer }),
          );
        }
      },
      [at, name, text],
    );
    await this.#frames();
  }

  /** Takes a picture, keeps it in the folder `RIEMAP_SHOTS` if that is set, and returns its colours' counts. */
  async picture(name) {
    await this.#frames();
    const folder = process.env.RIEMAP_SHOTS;
    if (folder) mkdirSync(folder, { recursive: true });
    const png = await this.#page.screenshot(folder ? { path: join(folder, `${name}.png`) } : {});
    return this.#page.evaluate(countColours, png.toString('base64'));
  }
}

function between(from, to, steps) {
  return Array.from({ length: steps }, (_, k) => from.map((start, axis) => start + ((to[axis] - start) * (k + 1)) / steps));
}

/** Runs in the page: how many pixels each colour has, the most frequent first, in steps of 16. */
async function countColours(png) {
  const bytes = Uint8Array.from(atob(png), (c) => c.charCodeAt(0));
  const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
  const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
  context.drawImage(bitmap, 0, 0);
  const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
  const counts = new Map();
  for (let k = 0; k < data.length; k += 4) {
    const colour = (data[k] >> 4) * 256 + (data[k + 1] >> 4) * 16 + (data[k + 2] >> 4);
    counts.set(colour, (counts.get(colour) ?? 0) + 1);
  }
  return [...counts.values()].sort((a, b) => b - a);
}
