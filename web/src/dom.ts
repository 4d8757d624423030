// Elements without markup in texts: what comes from a report is only ever text.

type Child = Node | string;
type Attributes = Record<string, string | ((event: Event) => void)>;

export function el<K extends keyof HTMLElementTagNameMap>(
  tag: K, attributes: Attributes = {}, ...children: Child[]): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === 'string') element.setAttribute(name, value);
    else element.addEventListener(name, value);
  }
  element.append(...children);
  return element;
}

export function svg(tag: string, attributes: Record<string, string | number>, ...children: Node[]): SVGElement {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  element.append(...children);
  return element;
}

const grouped = new Map<number, Intl.NumberFormat>();

// With so many decimals, and thin spaces between thousands.
export function number(value: number | null | undefined, digits = 0): string {
  if (typeof value !== 'number' || !Number.isFinite(value)) return '';
  let format = grouped.get(digits);
  if (!format) {
    format = new Intl.NumberFormat('en', { minimumFractionDigits: digits, maximumFractionDigits: digits });
    grouped.set(digits, format);
  }
  return format.format(value).replaceAll(',', '\u2009');
}

// "unknown", "0.0", "< 0.1" or "12.3": as AreaText in coordinator/report/json_access.h. A single mesh may be small: its
// areas below 0.1 have two significant digits.
export function areaText(area: number | null | undefined, isMesh = false): string {
  if (typeof area !== 'number' || !Number.isFinite(area)) return 'unknown';
  if (area === 0 || area >= 0.1) return number(area, 1);
  return isMesh ? String(Number(area.toPrecision(2))) : '< 0.1';
}

// The same of a volume; "" if it is not known.
export function volumeText(volume: number | null | undefined): string {
  return typeof volume === 'number' ? areaText(volume) : '';
}

export function counted(count: number, noun: string): string {
  return `${number(count)} ${noun}${count === 1 ? '' : 's'}`;
}

// "7", or of several holes in one row "7 and 3 more".
export function holesText({ hole, holes }: { hole?: number; holes?: number[] }): string {
  const more = (holes?.length ?? 1) - 1;
  return more > 0 ? `${hole} and ${number(more)} more` : String(hole ?? '');
}
