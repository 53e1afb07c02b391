// Serves a folder on a free local port under any base path, with the content types that browsers require; optionally
// compressed, and with a pause in the middle of a file.

import { readFileSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, normalize, sep } from 'node:path';
import { createGzip } from 'node:zlib';

const TYPES = new Map([
  ['.css', 'text/css'],
  ['.html', 'text/html; charset=utf-8'],
  ['.ico', 'image/x-icon'],
  ['.js', 'text/javascript'],
  ['.json', 'application/json'],
  ['.png', 'image/png'],
  ['.svg', 'image/svg+xml'],
  ['.wasm', 'application/wasm'],
  ['.webmanifest', 'application/manifest+json'],
]);

/** The file for a request under the base path `below`, or null if `folder` does not contain it. */
function fileFor(folder, below, url) {
  const whole = decodeURIComponent(new URL(url, 'http://localhost').pathname);
  if (!whole.startsWith(below)) return null;
  const path = whole.slice(below.length - 1);
  const file = normalize(join(folder, path.endsWith('/') ? `${path}index.html` : path));
  const inside = file.startsWith(normalize(folder + sep));
  return inside && statSync(file, { throwIfNoEntry: false })?.isFile() ? file : null;
}

/** Sends the first half of a file, waits for `halfway`, and sends the rest. */
async function send(file, response, packed, halfway) {
  const bytes = readFileSync(file);
  const middle = bytes.length >> 1;
  const encoder = packed ? createGzip({ level: 1 }) : null;
  encoder?.pipe(response);
  (encoder ?? response).write(bytes.subarray(0, middle));
  encoder?.flush();
  await halfway;
  (encoder ?? response).end(bytes.subarray(middle));
}

/**
 * Starts the server. `address` is the address to open; `close()` stops the server after all requests are answered.
 * `halfway(file)` is awaited in the middle of a file.
 */
export async function serve(folder, { packed = false, below = '/', halfway = () => null } = {}) {
  const underway = new Set();
  const server = createServer((request, response) => {
    const file = fileFor(folder, below, request.url);
    if (!file) {
      response.writeHead(404).end();
      return;
    }
    const answered = new Promise((resolve) => response.on('close', resolve));
    underway.add(answered);
    answered.then(() => underway.delete(answered));
    const encoding = packed ? { 'content-encoding': 'gzip' } : {};
    response.writeHead(200, { 'content-type': TYPES.get(extname(file)) ?? 'application/octet-stream', ...encoding });
    send(file, response, packed, halfway(file));
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  const close = async () => {
    const closed = new Promise((resolve) => server.close(resolve));
    await Promise.all(underway);
    server.closeAllConnections();
    return closed;
  };
  return { address: `http://127.0.0.1:${server.address().port}${below}`, close };
}
