// The warnings of a report, as a list that folds if it is long.
import { counted, el } from './dom';

const MOST_WARNINGS = 5; // that are not folded

export function warningList(texts: string[]): HTMLElement {
  const list = el('ul', {}, ...texts.map((text) => el('li', {}, text)));
  const title = counted(texts.length, 'warning');
  return texts.length > MOST_WARNINGS ? el('details', { class: 'warnings' }, el('summary', {}, title), list)
    : el('section', { class: 'warnings' }, el('h2', {}, title), list);
}
