// A list that makes the rows that are seen and some around them, however many there are. A row is of one of two heights,
// that of headings or that of all others, which are measured at the first that is made.

export interface RowMaker<T> {
  row(item: T): HTMLElement;
  isHeading(item: T): boolean;
}

const few = 120; // so many are made at once
const around = 12; // rows above and below what is seen
const guess = { heading: 28, row: 48 }; // points, until one is there

export class LongList<T> {
  private items: T[] = [];
  private tops: Float64Array = new Float64Array(1); // where each item begins, and behind the last where it ends
  private heights = { ...guess };
  private readonly made = new Map<number, HTMLElement>();
  private readonly above = document.createElement('li');
  private readonly below = document.createElement('li');

  constructor(
    private readonly list: HTMLElement,
    private readonly maker: RowMaker<T>,
  ) {
    for (const room of [this.above, this.below]) {
      room.className = 'room';
      room.setAttribute('aria-hidden', 'true');
    }
    list.tabIndex = -1;
    list.addEventListener('scroll', () => this.makeSeen());
    new ResizeObserver(() => this.makeSeen()).observe(list);
  }

  /// Other items; `none` is said where there are none. The place in the list and what has the focus are kept.
  fill(items: T[], none: string): void {
    const { list } = this;
    const { scrollTop } = list;
    const focused = list.contains(document.activeElement) ? (document.activeElement as HTMLElement).dataset.key : undefined;
    this.items = items;
    this.made.clear();
    list.replaceChildren();
    if (items.length === 0) {
      const item = document.createElement('li');
      item.className = 'none';
      item.textContent = none;
      list.append(item);
    } else {
      if (items.length > few) list.append(this.above, this.below);
      this.placeItems();
      this.makeSeen(scrollTop);
      list.scrollTop = scrollTop;
    }
    if (focused) list.querySelector<HTMLElement>(`[data-key="${focused}"]`)?.focus();
  }

  /// The rows that there are now.
  get rows(): Iterable<HTMLElement> {
    return this.made.values();
  }

  /// Scrolls no further than is needed to see an item.
  reveal(index: number): void {
    if (index < 0 || index >= this.items.length) return;
    this.makeSeen();
    if (this.items.length <= few) return this.made.get(index)?.scrollIntoView({ block: 'nearest' });
    this.goTo(index);
    this.goTo(index); // where the rows that are there now are of another height than was thought
  }

  private goTo(index: number): void {
    const { list } = this;
    const [top, bottom] = [this.tops[index], this.tops[index + 1]];
    if (top < list.scrollTop) list.scrollTop = top;
    else if (bottom > list.scrollTop + list.clientHeight) list.scrollTop = bottom - list.clientHeight;
    this.makeSeen();
  }

  private placeItems(): void {
    const { items, heights, maker } = this;
    this.tops = new Float64Array(items.length + 1);
    items.forEach((item, i) => (this.tops[i + 1] = this.tops[i] + (maker.isHeading(item) ? heights.heading : heights.row)));
  }

  /// The item at so many points from the top.
  private itemAt(top: number): number {
    let [low, high] = [0, this.items.length - 1];
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.tops[middle] <= top) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  private makeSeen(scrollTop = this.list.scrollTop): void {
    const { items, list } = this;
    if (items.length === 0) return;
    if (items.length <= few) return this.make(0, items.length);
    const seen = () => {
      const first = this.itemAt(scrollTop);
      return [Math.max(0, first - around), Math.min(items.length, this.itemAt(scrollTop + list.clientHeight) + around + 1)];
    };
    this.make(...(seen() as [number, number]));
    if (this.measure()) this.make(...(seen() as [number, number]));
  }

  /// These rows and no others; those that are there already stay, with what has the focus.
  private make(first: number, end: number): void {
    const { made, list, items } = this;
    for (const [i, row] of made)
      if (i < first || i >= end) {
        if (row.contains(document.activeElement)) list.focus({ preventScroll: true }); // keys go on scrolling the list
        row.remove();
        made.delete(i);
      }
    const isLong = items.length > few;
    let next: Element | null = isLong ? this.below : null;
    for (let i = end - 1; i >= first; --i) {
      let row = made.get(i);
      if (!row) {
        row = this.maker.row(items[i]);
        if (isLong) {
          row.setAttribute('aria-setsize', String(items.length));
          row.setAttribute('aria-posinset', String(i + 1));
        }
        made.set(i, row);
        list.insertBefore(row, next);
      }
      next = row;
    }
    this.above.style.height = `${this.tops[first]}px`;
    this.below.style.height = `${this.tops[items.length] - this.tops[end]}px`;
  }

  /// Whether a height was another than was thought.
  private measure(): boolean {
    const before = { ...this.heights };
    for (const [i, row] of this.made) {
      const { height } = row.getBoundingClientRect();
      if (height > 0) this.heights[this.maker.isHeading(this.items[i]) ? 'heading' : 'row'] = height;
    }
    if (before.heading === this.heights.heading && before.row === this.heights.row) return false;
    this.placeItems();
    return true;
  }
}
