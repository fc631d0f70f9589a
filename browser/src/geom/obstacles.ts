/** What wires go around: task boxes, and the loci of other variables (§5.3.5). */

import { Cells } from './cells'
import { areaOf, around, grown, holds, touches, union, type Area, type Pt, type Rect } from './rect'

/** How far a wire keeps from a box where there is room, and the length of the stub at a pin. */
export const PAD = 10
/** Half the side of the square that keeps foreign wires off a locus: its dot of 5 and some air. */
export const LOCUS_PAD = 7

/** `core` may never be crossed; the sides of `wide` are where wires run. */
export interface Obstacle {
  readonly core: Area
  readonly wide: Area
}

export type Side = 'left' | 'right'

interface Box extends Area {
  readonly id: string
  obstacle: Obstacle | null // null: its neighbours changed, ask again
}

interface Locus extends Area, Obstacle {
  readonly svar: string
}

export class Obstacles {
  private readonly boxes = new Map<string, Box>()
  private readonly loci = new Map<string, Locus>()
  private readonly boxCells = new Cells<Box>()
  private readonly locusCells = new Cells<Locus>()

  setBox(id: string, rect: Rect): void {
    this.removeBox(id)
    const box: Box = { id, ...areaOf(rect), obstacle: null }
    this.boxes.set(id, box)
    this.forgetNeighbours(box)
    this.boxCells.add(box)
  }

  removeBox(id: string): void {
    const box = this.boxes.get(id)
    if (!box) return
    this.boxes.delete(id)
    this.boxCells.drop(box)
    this.forgetNeighbours(box)
  }

  setLocus(svar: string, x: number, y: number): void {
    this.removeLocus(svar)
    const wide = around(x, y, LOCUS_PAD)
    const locus: Locus = { svar, ...wide, wide, core: around(x, y, 0) }
    this.loci.set(svar, locus)
    this.locusCells.add(locus)
  }

  removeLocus(svar: string): void {
    const locus = this.loci.get(svar)
    if (!locus) return
    this.loci.delete(svar)
    this.locusCells.drop(locus)
  }

  /** The box as an obstacle; it must exist. */
  box(id: string): Obstacle {
    return this.obstacle(this.boxes.get(id)!)
  }

  /** What stands in the way of a variable's wires within an area. */
  blocking(area: Area, svar: string): Obstacle[] {
    const obstacles: Obstacle[] = []
    for (const box of this.boxCells.near(grown(area, PAD))) {
      const obstacle = this.obstacle(box)
      if (touches(obstacle.wide, area)) obstacles.push(obstacle)
    }
    for (const locus of this.locusCells.near(area)) if (locus.svar !== svar) obstacles.push(locus)
    return obstacles
  }

  /** The boxes themselves that touch an area. */
  boxesNear(area: Area): Area[] {
    return this.boxCells.near(area)
  }

  /** The squares of the loci of other variables that touch an area. */
  foreignLoci(area: Area, svar: string): Area[] {
    return this.locusCells.near(area).filter((locus) => locus.svar !== svar)
  }

  /** The area of everything; null where there is nothing. */
  bounds(): Area | null {
    return union([...this.boxCells.all(), ...this.locusCells.all()])
  }

  private obstacle(box: Box): Obstacle {
    return (box.obstacle ??= { core: box, wide: this.widened(box) })
  }

  /**
   * The box with PAD around it, with less where a neighbour stands nearer than twice that: each takes half of the gap.
   * So no two widened boxes overlap, and between boxes that touch a wire can still run along the border.
   */
  private widened(box: Box): Area {
    let [left, right, top, bottom] = [PAD, PAD, PAD, PAD]
    for (const other of this.boxCells.near(grown(box, 2 * PAD))) {
      if (other === box) continue
      const gapX = Math.max(other.x0 - box.x1, box.x0 - other.x1)
      const gapY = Math.max(other.y0 - box.y1, box.y0 - other.y1)
      if (gapX < 0 && gapY < 0) continue // they lie on each other: no gap to share
      if (gapX >= gapY) {
        if (other.x0 >= box.x1) right = Math.min(right, gapX / 2)
        else left = Math.min(left, gapX / 2)
      } else if (other.y0 >= box.y1) bottom = Math.min(bottom, gapY / 2)
      else top = Math.min(top, gapY / 2)
    }
    return { x0: box.x0 - left, y0: box.y0 - top, x1: box.x1 + right, y1: box.y1 + bottom }
  }

  private forgetNeighbours(box: Area): void {
    for (const other of this.boxCells.near(grown(box, 2 * PAD))) other.obstacle = null
  }
}

/**
 * The widened obstacle with one side moved to `p` where `p` lies within it, so that a wire can begin or end there.
 * It gives up padding as long as that is enough, and of the obstacle itself only the strip to its nearest side.
 */
export function cleared(wide: Area, core: Area, p: Pt): Area {
  if (!holds(wide, p)) return wide
  const [x, y] = p
  const inside = holds(core, p)
  const losses: [number, Area][] = []
  if (inside || x <= core.x0) losses.push([x - wide.x0, { ...wide, x0: x }])
  if (inside || x >= core.x1) losses.push([wide.x1 - x, { ...wide, x1: x }])
  if (inside || y <= core.y0) losses.push([y - wide.y0, { ...wide, y0: y }])
  if (inside || y >= core.y1) losses.push([wide.y1 - y, { ...wide, y1: y }])
  return losses.reduce((least, loss) => (loss[0] < least[0] ? loss : least))[1]
}
