/** A table to sort, filter, page through and export. */
import { csvText, download } from './csv';
import { button, clear, h, select } from './dom';
import { parseCondition, sortRows, type Column } from './rows';
import { view } from './view';

export type { Column } from './rows';

export interface TableOptions {
  name: string;
  caption: string;
  columns: Column[];
  rows: number;
  /** An example of what may be typed into the filter. */
  hint?: string;
  /** Whether other views let a row through. */
  passes?: (row: number) => boolean;
  rowClass?: (row: number) => string;
  onHover?: (row: number | null) => void;
  /** Told what the table's own filter lets through; null for everything. */
  onFilter?: (rows: Set<number> | null) => void;
}

export class Table {
  readonly element: HTMLElement;
  private readonly body = h('tbody');
  private readonly head = h('tr');
  private readonly status = h('p', { class: 'note', role: 'status' });
  private readonly pages = h('div', { class: 'row pages' });
  private sorted: { column: Column; up: boolean } | null = null;
  private own: ((row: number) => boolean) | null = null;
  private page = 0;
  private perPage = 25;

  constructor(private readonly options: TableOptions) {
    const filter = h('input', {
      type: 'search',
      class: 'filter',
      placeholder: options.hint ?? 'text',
      input: () => {
        view.set(`filter.${options.caption}`, filter.value);
        this.own = parseCondition(filter.value, options.columns);
        this.page = 0;
        if (options.onFilter) {
          options.onFilter(this.own ? new Set(this.all().filter(this.own)) : null);
        }
        this.update();
      },
    });
    this.element = h(
      'div',
      { class: 'table' },
      h(
        'div',
        { class: 'row' },
        h('label', { class: 'field wide' }, h('span', {}, 'Filter'), filter),
        select(
          'Rows',
          ['25', '50', '100'].map((n) => ({ value: n, text: n })),
          '25',
          (value) => {
            this.perPage = Number(value);
            this.page = 0;
            this.update();
          },
        ),
        button('Export as CSV', () => this.export()),
      ),
      h(
        'div',
        { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': options.caption },
        h('table', {}, h('caption', {}, options.caption), h('thead', {}, this.head), this.body),
      ),
      this.pages,
      this.status,
    );
    filter.value = view.get(`filter.${options.caption}`, '');
    if (filter.value) filter.dispatchEvent(new Event('input'));
    else this.update();
  }

  private all(): number[] {
    return Array.from({ length: this.options.rows }, (_, k) => k);
  }

  private visible(): number[] {
    const { passes } = this.options;
    const rows = this.all().filter((row) => (!this.own || this.own(row)) && (!passes || passes(row)));
    return this.sorted ? sortRows(rows, this.sorted.column, this.sorted.up) : rows;
  }

  private export(): void {
    const { columns, name } = this.options;
    const rows = this.visible().map((row) => columns.map((column) => column.value(row)));
    download(`${name}.csv`, csvText([columns.map((column) => column.key), ...rows]));
  }

  sortBy(key: string): void {
    const column = this.options.columns.find((one) => one.key === key);
    if (!column) return;
    this.sorted = { column, up: this.sorted?.column === column ? !this.sorted.up : true };
    this.page = 0;
    this.update();
  }

  update(): void {
    const { columns, rowClass, onHover } = this.options;
    clear(this.head);
    for (const column of columns) {
      const here = this.sorted?.column === column;
      const arrow = here ? (this.sorted!.up ? ' ▲' : ' ▼') : '';
      this.head.append(
        h(
          'th',
          {
            scope: 'col',
            class: column.numeric ? 'number' : '',
            'aria-sort': here ? (this.sorted!.up ? 'ascending' : 'descending') : 'none',
          },
          button(column.label + arrow, () => this.sortBy(column.key), {
            class: 'sort',
            title: column.title,
          }),
        ),
      );
    }
    const rows = this.visible();
    const pages = Math.max(1, Math.ceil(rows.length / this.perPage));
    this.page = Math.min(this.page, pages - 1);
    const shown = rows.slice(this.page * this.perPage, (this.page + 1) * this.perPage);
    this.body.replaceChildren(
      ...shown.map((row) => {
        const cells = columns.map((column) =>
          h('td', { class: column.numeric ? 'number' : column.name ? 'name' : '' }, column.show ? column.show(row) : String(column.value(row) ?? '–')),
        );
        const line = h('tr', { class: rowClass?.(row) ?? '' }, ...cells);
        if (onHover) {
          line.addEventListener('mouseenter', () => onHover(row));
          line.addEventListener('mouseleave', () => onHover(null));
        }
        return line;
      }),
    );
    const turn = (by: number): void => {
      this.page += by;
      this.update();
    };
    this.pages.replaceChildren(
      button('Previous', () => turn(-1), { disabled: this.page === 0 }),
      h('span', {}, `page ${this.page + 1} of ${pages}`),
      button('Next', () => turn(1), { disabled: this.page >= pages - 1 }),
    );
    this.pages.hidden = pages === 1;
    this.status.textContent = `${rows.length} of ${this.options.rows} rows`;
  }
}
