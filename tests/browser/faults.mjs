// What goes wrong behind the scenes: errors that nobody caught, files that are not loaded, and what the browser
// reports on its console.

/** Warnings that are as bad as errors. */
const SERIOUS = /WebGL: |WebGPU|validation|\[Intervention\]|Content Security Policy/i;

const isFault = (message) => message.type() === 'error' || (message.type() === 'warning' && SERIOUS.test(message.text()));

/** The list of the faults of all pages of a context, which grows from now on; without those that are `expected`. */
export function watch(context, expected = null) {
  const faults = [];
  const note = (fault) => expected?.test(fault) || faults.push(fault);
  context.on('weberror', (event) => note(`uncaught: ${event.error().stack ?? event.error()}`));
  context.on('requestfailed', (request) => {
    // a reload gives up what is still on its way, such as the icon
    if (request.failure()?.errorText !== 'net::ERR_ABORTED') note(`not loaded: ${request.url()}`);
  });
  context.on('console', (message) => {
    if (isFault(message)) note(`console: ${message.text()} (${message.location().url})`);
  });
  return faults;
}
