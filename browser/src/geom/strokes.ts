/** The cells of simple figures on a grid: lines, rectangles, ellipses. */

export type Cell = readonly [number, number]

/** From one cell to another without gaps (Bresenham). */
export function line([x0, y0]: Cell, [x1, y1]: Cell): Cell[] {
  const cells: Cell[] = []
  const [dx, dy] = [Math.abs(x1 - x0), -Math.abs(y1 - y0)]
  const [sx, sy] = [x0 < x1 ? 1 : -1, y0 < y1 ? 1 : -1]
  let [x, y, error] = [x0, y0, dx + dy]
  for (;;) {
    cells.push([x, y])
    if (x === x1 && y === y1) return cells
    const twice = 2 * error
    if (twice >= dy) {
      error += dy
      x += sx
    }
    if (twice <= dx) {
      error += dx
      y += sy
    }
  }
}

export function rectangle(a: Cell, b: Cell, filled: boolean): Cell[] {
  const [x0, x1, y0, y1] = box(a, b)
  const cells: Cell[] = []
  for (let y = y0; y <= y1; y++) {
    for (let x = x0; x <= x1; x++) if (filled || x === x0 || x === x1 || y === y0 || y === y1) cells.push([x, y])
  }
  return cells
}

/** The ellipse that fills a box: the cells whose centres lie in it, or of these the ones with a neighbour outside. */
export function ellipse(a: Cell, b: Cell, filled: boolean): Cell[] {
  const [x0, x1, y0, y1] = box(a, b)
  const [cx, cy, rx, ry] = [(x0 + x1) / 2, (y0 + y1) / 2, (x1 - x0 + 1) / 2, (y1 - y0 + 1) / 2]
  const within = (x: number, y: number): boolean => ((x - cx) / rx) ** 2 + ((y - cy) / ry) ** 2 <= 1
  const rim = (x: number, y: number): boolean =>
    !within(x - 1, y) || !within(x + 1, y) || !within(x, y - 1) || !within(x, y + 1)
  return rectangle(a, b, true).filter(([x, y]) => within(x, y) && (filled || rim(x, y)))
}

const box = ([ax, ay]: Cell, [bx, by]: Cell): [number, number, number, number] => [
  Math.min(ax, bx),
  Math.max(ax, bx),
  Math.min(ay, by),
  Math.max(ay, by),
]
