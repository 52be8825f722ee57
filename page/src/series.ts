/** Time series: float columns, byte planes, zlib. */

export interface Series {
  columns: string[];
  /** One list per column; NaN where a value is not defined. */
  values: Float32Array[];
  rows: number;
}

/** Inflates zlib data (RFC 1950). */
export async function inflate(bytes: Uint8Array): Promise<Uint8Array> {
  const stream = new Blob([bytes as BlobPart]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Four bytes of length, a JSON header {columns, rows}, then the compressed planes. */
export async function readSeries(bytes: Uint8Array): Promise<Series> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const size = view.getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + size))) as {
    columns: string[];
    rows: number;
  };
  const planes = await inflate(bytes.subarray(4 + size));
  const { columns, rows } = header;
  if (planes.length !== 4 * columns.length * rows) throw new Error('the series are damaged');
  const values = columns.map((_, column) => {
    const raw = new Uint8Array(4 * rows);
    const start = 4 * rows * column;
    for (let plane = 0; plane < 4; ++plane) {
      for (let row = 0; row < rows; ++row) raw[4 * row + plane] = planes[start + plane * rows + row]!;
    }
    return new Float32Array(raw.buffer);
  });
  return { columns, values, rows };
}

/** A column of the series; null where there is none. */
export function column(series: Series, name: string): Float32Array | null {
  const at = series.columns.indexOf(name);
  return at < 0 ? null : series.values[at]!;
}

/** The value at a time between two samples; NaN out of the series. */
export function valueAt(series: Series, values: Float32Array, time: number): number {
  const times = series.values[0]!;
  const n = series.rows;
  if (n === 0 || time < times[0]! || time > times[n - 1]! + 1e-6) return NaN;
  let low = 0;
  let high = n - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle]! <= time) low = middle;
    else high = middle;
  }
  const span = times[high]! - times[low]!;
  const share = span > 0 ? Math.min(1, (time - times[low]!) / span) : 0;
  return values[low]! + share * (values[high]! - values[low]!);
}
