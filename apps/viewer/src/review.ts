// What people say of clashes: a status and a comment each, kept in a file that one can send (docs/reference/view-page.md).
// Pairs are known by the names of their objects, in either order, so that the file also fits a later page.
import { parsedVisibly } from './visible';

export const statuses = ['open', 'active', 'reviewed', 'approved', 'resolved'] as const;
export type ReviewStatus = (typeof statuses)[number];

export interface Remark {
  a: string;
  b: string;
  status: ReviewStatus;
  comment: string;
}

const format = 'toccata-review';
const keyOf = (a: string, b: string) => JSON.stringify([a, b].sort());

export class Review {
  onChanged: (changed: boolean) => void = () => undefined;
  private isChanged = false; // since it was saved or opened
  private readonly remarks = new Map<string, Remark>();

  set changed(changed: boolean) {
    this.isChanged = changed;
    this.onChanged(changed);
  }

  get changed(): boolean {
    return this.isChanged;
  }

  of(a: string, b: string): Remark {
    return this.remarks.get(keyOf(a, b)) ?? { a, b, status: 'open', comment: '' };
  }

  set(remark: Remark): void {
    this.changed = true;
    const key = keyOf(remark.a, remark.b);
    if (remark.status === 'open' && remark.comment === '') this.remarks.delete(key);
    else this.remarks.set(key, remark);
  }

  get count(): number {
    return this.remarks.size;
  }

  text(): string {
    return `${JSON.stringify({ format, version: 1, clashes: [...this.remarks.values()] }, null, 2)}\n`;
  }

  /// Takes over what the text of a file says; what is of the same pair is replaced. Throws an Error that says what is
  /// wrong with it. Returns how many it says something of.
  read(text: string): number {
    let file: unknown;
    try {
      file = parsedVisibly(text);
    } catch {
      throw new Error('it is no JSON');
    }
    const { format: named, version, clashes } = (file ?? {}) as { format?: unknown; version?: unknown; clashes?: unknown };
    if (named !== format || version !== 1 || !Array.isArray(clashes)) throw new Error('it is no review that this page saves');
    const read = clashes.map((entry, i) => remarkOf(entry, i));
    for (const remark of read) this.remarks.set(keyOf(remark.a, remark.b), remark); // what was not saved still is not
    return read.length;
  }
}

function remarkOf(entry: unknown, i: number): Remark {
  const { a, b, status, comment } = (entry ?? {}) as Record<string, unknown>;
  const known = statuses.find((one) => one === status);
  if (typeof a !== 'string' || typeof b !== 'string' || typeof comment !== 'string') throw new Error(`clash ${i} lacks a, b or a comment`);
  if (!known) throw new Error(`clash ${i} has the status “${String(status)}”; there are ${statuses.join(', ')}`);
  return { a, b, status: known, comment };
}
