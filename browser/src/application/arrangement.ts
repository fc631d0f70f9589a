/**
 * Where everything of an application stands: flows one below the other, each in rows that wrap around and never part an
 * action from its targets (§5.5.5); branches in line, their flows as lanes below each other that split and join (D13).
 */

import { BAND, onikonWidth } from '../geom/jigsaw'
import { moved, Sheet } from './sheet'

/** What stands in a row and is no step of the application. */
export const START = 0
export const END = -1
/** The place that opens for what is carried. */
export const GHOST = -2
/** The room between start and end of a flow in which nothing stands. */
export const EMPTY = -3
/** The ends of a lane: bands without a picture. */
export const LANE_START = -4
export const LANE_END = -5

/** From the side of a branch to its lanes. */
export const FORK = 34
const LANE_LABEL = 8
/** What the condition of the first lane of a branch needs above its row: nothing of the row before stands there. */
const CONDITION = 18

export interface Known {
  /** Whether it stays with the step before it: the target of an action, or the hole for it. */
  readonly joined: boolean
  readonly isHole: boolean
  /** Of a branch: the paths of its flows. */
  readonly flows: readonly string[]
}

export interface Content {
  /** The paths of the application's own flows, in order. */
  readonly tops: readonly string[]
  steps(path: string): readonly number[]
  step(number: number): Known
}

export interface Frame {
  readonly width: number
  /** The side of a picture. */
  readonly size: number
  /** More room between rows, where loops lie within loops. */
  readonly extra: number
}

export interface Place {
  readonly flow: string
  readonly after: number
}

/** One thing in a row. */
export interface Cell {
  readonly step: number
  readonly flow: string
  x: number
  y: number
  readonly w: number
}

/** Where something can be inserted: behind a step; `hole` stands there. Where a row wraps, its two ends mean the same. */
export interface Gap extends Place {
  x: number
  y: number
  readonly hole: number
  readonly isSecond: boolean
}

/** A branch: lanes between a fork and a join. */
export interface Block {
  readonly step: number
  readonly flow: string
  x: number
  y: number
  readonly w: number
  readonly h: number
  /** The room that conditions take above its row. */
  readonly above: number
  readonly lanes: Lane[]
}

/** A flow of a branch: where it begins, and where it ends, which may be in a lower row. */
export interface Lane {
  readonly path: string
  x: number
  y: number
  /** How far above its row its condition stands: above those of a branch with which it begins. */
  readonly above: number
  endX: number
  endY: number
}

/** From the end of a row to the beginning of the next. */
export interface Wrap {
  right: number
  y: number
  left: number
  next: number
  /** The room that conditions take above the next row. */
  readonly above: number
}

export interface Arrangement {
  readonly cells: readonly Cell[]
  readonly gaps: readonly Gap[]
  readonly blocks: readonly Block[]
  readonly wraps: readonly Wrap[]
  /** Where the flows of the application itself begin. */
  readonly heads: readonly { readonly path: string; readonly y: number; readonly bottom: number }[]
  readonly height: number
}

export const MARGIN = 36
const TOP = 46
const HEAD = 30

export const rowGap = ({ size, extra }: Frame): number => 26 + size / 4 + extra

/** Everything, and the height it takes; `opened` is where something carried would go. */
export function arrange(content: Content, frame: Frame, opened?: Place): Arrangement {
  const sheet = new Sheet()
  const heads: Arrangement['heads'][number][] = []
  const laying = new Laying(content, frame, opened)
  let y = TOP
  for (const path of content.tops) {
    const flow = laying.flow(path, frame.width - 2 * MARGIN, false)
    y += flow.above
    sheet.take(flow, MARGIN, y)
    heads.push({ path, y, bottom: y + flow.h })
    y += flow.h + rowGap(frame) + HEAD
  }
  return { ...sheet, heads, height: y }
}

/** A step on its way into a row. */
interface Piece {
  readonly step: number
  readonly w: number
  readonly h: number
  readonly isHole: boolean
  readonly inside?: Sheet | undefined
  /** Its lanes, for a branch. */
  readonly block?: Block | undefined
}

class Laying {
  private readonly width: number

  constructor(
    private readonly content: Content,
    private readonly frame: Frame,
    private readonly opened: Place | undefined,
  ) {
    this.width = onikonWidth(frame.size)
  }

  /** A flow in rows that are not longer than `limit`. */
  flow(path: string, limit: number, isLane: boolean): Sheet {
    const sheet = new Sheet()
    let before: { piece: Piece; x: number; y: number } | undefined
    let y = 0
    for (const [k, row] of this.rows(path, limit, isLane).entries()) {
      const above = Math.max(...row.map((piece) => piece.block?.above ?? 0))
      if (k === 0) sheet.above = above
      else y = sheet.h + rowGap(this.frame) + above
      let x = 0
      for (const piece of row) {
        this.put(sheet, path, piece, x, y)
        if (before) this.between(sheet, path, before, { piece, x, y }, above)
        before = { piece, x, y }
        x += piece.w
      }
      sheet.w = Math.max(sheet.w, x)
      sheet.h = y + Math.max(this.frame.size, ...row.map(({ h }) => h))
    }
    return sheet
  }

  /** What stands beside each other; an action is parted from its targets only where it is longer than a row. */
  private rows(path: string, limit: number, isLane: boolean): Piece[][] {
    const rows: Piece[][] = []
    let x = 0
    const begin = (): void => {
      rows.push([])
      x = 0
    }
    begin()
    for (const group of this.groups(path, limit, isLane)) {
      const width = group.reduce((sum, piece) => sum + piece.w, 0)
      if (x > 0 && x + width > limit) begin()
      for (const piece of group) {
        if (x > 0 && x + piece.w > limit && width > limit) begin()
        rows.at(-1)!.push(piece)
        x += piece.w
      }
    }
    return rows
  }

  private put(sheet: Sheet, flow: string, piece: Piece, x: number, y: number): void {
    if (piece.inside) sheet.take(piece.inside, x, y)
    if (piece.block) {
      const { block } = piece
      sheet.blocks.push({ ...block, x, y, lanes: block.lanes.map((lane) => moved(lane, x, y)) })
    } else sheet.cells.push({ step: piece.step, flow, x, y, w: piece.w })
  }

  /** The gap between two neighbours, and the arrow where a row ends between them. */
  private between(
    sheet: Sheet,
    flow: string,
    a: { piece: Piece; x: number; y: number },
    b: { piece: Piece; x: number; y: number },
    above: number,
  ): void {
    const right = a.x + a.piece.w
    if (a.y !== b.y) sheet.wraps.push({ right, y: a.y, left: b.x, next: b.y, above })
    if (a.piece.isHole || a.piece.step === GHOST || b.piece.step === GHOST) return
    const after = a.piece.step > 0 ? a.piece.step : START
    if (b.piece.isHole) {
      sheet.gaps.push({ flow, after, x: b.x + b.piece.w / 2, y: b.y, hole: b.piece.step, isSecond: false })
      return
    }
    sheet.gaps.push({ flow, after, x: right, y: a.y, hole: 0, isSecond: false })
    if (a.y !== b.y) sheet.gaps.push({ flow, after, x: b.x, y: b.y, hole: 0, isSecond: true })
  }

  /** What stays together: an action with its targets; all else alone. */
  private groups(path: string, limit: number, isLane: boolean): Piece[][] {
    const groups: Piece[][] = []
    const numbers = this.content.steps(path)
    const opened = this.opened?.flow === path ? this.opened.after : undefined
    const alone = (step: number, w = this.width, isHole = false): number =>
      groups.push([{ step, w, h: this.frame.size, isHole }])
    alone(isLane ? LANE_START : START, isLane ? BAND : this.width)
    if (opened === START) alone(GHOST)
    else if (!numbers.length) alone(EMPTY, this.width, true)
    for (const number of numbers) {
      const stepView = this.content.step(number)
      const piece = stepView.flows.length
        ? this.branch(path, number, stepView.flows, limit)
        : { step: number, w: this.width, h: this.frame.size, isHole: stepView.isHole }
      if (stepView.joined) groups.at(-1)!.push(piece)
      else groups.push([piece])
      if (opened === number) groups.at(-1)!.push({ step: GHOST, w: this.width, h: this.frame.size, isHole: false })
    }
    alone(isLane ? LANE_END : END, isLane ? BAND : this.width)
    return groups
  }

  private branch(flow: string, step: number, paths: readonly string[], limit: number): Piece {
    const inside = new Sheet()
    const lanes: Lane[] = []
    const room = Math.max(this.width + 2 * BAND, limit - 2 * FORK)
    let [above, h, widest] = [0, 0, 0]
    for (const [k, path] of paths.entries()) {
      const lane = this.flow(path, room, true)
      const y = k ? h + rowGap(this.frame) + LANE_LABEL + lane.above : 0
      if (k === 0) above = CONDITION + lane.above // its row is that of the branch
      inside.take(lane, FORK, y)
      const end = lane.cells.at(-1)! // each flow ends with its end
      lanes.push({ path, x: FORK, y, above: lane.above, endX: end.x + end.w, endY: end.y })
      widest = Math.max(widest, lane.w)
      h = y + lane.h
    }
    const w = widest + 2 * FORK
    return { step, w, h, isHole: false, inside, block: { step, flow, x: 0, y: 0, w, h, above, lanes } }
  }
}
