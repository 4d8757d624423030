// Command lines to copy.
import type { Report } from './data';
import { el } from './dom';

const SAFE = /^[\w@%+=:,./-]+$/; // words that a shell takes as they are

export const shellQuoted = (word: string): string => (SAFE.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`);

// One option as words. Of switches only those that are on can be given.
function wordsOf(name: string, value: unknown): string[] {
  if (typeof value === 'boolean') return value ? [`--${name}`] : [];
  const text = String(value);
  return text.startsWith('-') ? [`--${name}=${text}`] : [`--${name}`, text];
}

// Where a coordinator that listens there is reached from where its page is seen: if it listens on all addresses, as the
// page is. "" if it does not say.
export function coordinatorAt(listen: string, page: string): string {
  const [, host, port] = /^(.*):(\d+)$/.exec(listen) ?? [];
  if (!port) return '';
  return `${!host || host === '0.0.0.0' || host === '[::]' ? page : host}:${port}`;
}

// The run, or the job, of the report with the decisions of the review; null if the report does not tell its scene and
// folder.
export function decisionsCommand({ scene, out, changed_options: changed }: Pick<Report, 'scene' | 'out' | 'changed_options'>,
  verb: 'run' | 'submit' = 'run', coordinator = ''): string | null {
  if (!scene || !out) return null;
  const options = Object.entries(changed ?? {}).filter(([name]) => name !== 'decisions').flatMap(([name, value]) => wordsOf(name, value));
  const more = verb === 'submit' ? ['--coordinator', coordinator || 'HOST:PORT'] : [];
  return ['tilemend', verb, scene, '--out', out, ...options, '--decisions', verb === 'submit' ? 'FILE' : 'decisions.geojson', ...more].map(shellQuoted).join(' ');
}

// A command with a button that copies it. Where the browser forbids that, the button selects the text.
export function copyable(command: string): HTMLElement {
  const code = el('code', {}, command), status = el('span', { class: 'quiet', 'aria-live': 'polite' });
  const copy = async () => {
    try {
      await navigator.clipboard.writeText(command);
      status.textContent = 'copied';
    } catch {
      getSelection()?.selectAllChildren(code);
      status.textContent = 'selected: copy it with Ctrl+C';
    }
  };
  return el('div', { class: 'command' }, code, el('button', { type: 'button', class: 'copy', click: () => void copy() }, 'Copy'), status);
}
