/** Lines between and around onikons, as paths. */

import { edgeLine, type Vertices } from '../geom/jigsaw'
import { FORK, type Block, type Lane, type Wrap } from './arrangement'

const ROUND = 6

/** From the end of a row, round, to the beginning of the next, with an arrow's head. */
export function wrapPath({ right, y, left, next, above }: Wrap, size: number): string {
  const [from, to, between] = [y + size / 2, next + size / 2, next - 15 - above]
  return (
    `M${right + 3} ${from}h6q${ROUND} 0 ${ROUND} ${ROUND}V${between - ROUND}q0 ${ROUND} ${-ROUND} ${ROUND}H${left - 18}` +
    `q${-ROUND} 0 ${-ROUND} ${ROUND}V${to - ROUND}q0 ${ROUND} ${ROUND} ${ROUND}h13m-6 -4l6 4l-6 4`
  )
}

/** From the test of a loop to its anchor, below their row; both at the middle of their icons. */
export function loopPath(test: number, anchor: number, y: number, drop: number): string {
  const to = Math.sign(anchor - test) || -1
  return `M${test} ${y + 3}v${drop - ROUND}q0 ${ROUND} ${to * ROUND} ${ROUND}H${anchor - to * ROUND}q${to * ROUND} 0 ${to * ROUND} ${-ROUND}V${y + 4}m-4.5 6.500l4.5 -6.500l4.5 6.500`
}

/** The same where the two stand in different rows: by the left side of all rows. */
export function farLoopPath(
  test: { x: number; y: number },
  anchor: { x: number; y: number },
  side: number,
  drop: number,
): string {
  const turn = anchor.y > test.y ? 1 : -1
  const [low, high] = [test.y + drop, anchor.y + drop]
  return (
    `M${test.x} ${test.y + 3}V${low - ROUND}q0 ${ROUND} ${-ROUND} ${ROUND}H${side + ROUND}q${-ROUND} 0 ${-ROUND} ${turn * ROUND}V${high - turn * ROUND}` +
    `q0 ${turn * ROUND} ${ROUND} ${turn * ROUND}H${anchor.x - ROUND}q${ROUND} 0 ${ROUND} ${-ROUND}V${anchor.y + 4}m-4.5 6.500l4.5 -6.500l4.5 6.500`
  )
}

/** The lines of a branch: from its fork to the lanes, and from these to the join. */
export function forkPath({ x, y, w, lanes }: Block, size: number): string {
  const middle = y + size / 2
  const [from, to] = [x + 16, x + w - 16]
  const spine = FORK - 28
  const out = (lane: Lane): string => {
    const at = lane.y + size / 2
    if (at === middle) return `M${from} ${at}H${lane.x}`
    return `M${from + spine} ${middle}V${at - ROUND}q0 ${ROUND} ${ROUND} ${ROUND}H${lane.x}`
  }
  const back = (lane: Lane): string => {
    const at = lane.endY + size / 2
    if (at === middle) return `M${lane.endX} ${at}H${to}`
    return `M${lane.endX} ${at}H${to - spine - ROUND}q${ROUND} 0 ${ROUND} ${-ROUND}V${middle}`
  }
  return lanes.map((lane) => out(lane) + back(lane)).join('')
}

/** An edge alone, as the line of the insertion cursor. */
export const edgePath = (edge: Vertices, x: number, y: number, size: number): string =>
  `M${edgeLine(edge, x, y, size)
    .map((p) => p.join(' '))
    .join('L')}`

/** The contour of a row of onikons; of several pieces where they stand in several rows. */
export function around(
  left: Vertices,
  right: Vertices,
  cells: readonly { x: number; y: number; w: number }[],
  size: number,
): string {
  const rows: { x: number; y: number; end: number }[] = []
  for (const { x, y, w } of cells) {
    const row = rows.at(-1)
    if (row && row.y === y && row.end === x) row.end = x + w
    else rows.push({ x, y, end: x + w })
  }
  return rows
    .map(({ x, y, end }, k) => {
      const a = edgeLine(k === 0 ? left : [], x, y, size)
      const b = edgeLine(k === rows.length - 1 ? right : [], end, y, size).reverse()
      return `M${[...a, ...b].map((p) => p.join(' ')).join('L')}Z`
    })
    .join('')
}
