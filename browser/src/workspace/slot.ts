// Where what is carried would go, and why it would not: two edges meet or they do not (Equation 7).
import { desk } from '../link/desk.svelte'
import { gapAt as edgesAt } from '../onikon/fits'
import { typeTitle } from '../onikon/typewords'
import type { Place } from '../state/workspace.svelte'
import type { Point } from '../act/refused.svelte'
import { t } from '../texts/index.svelte'
import { workspaceState, type Slot } from './workspaceState.svelte'
import { cellAt, gapAt } from '../application/gaps'
import { nameOf } from '../application/words'

/** The slot under a place of the window, for something with these edges: an icon, or what lies between two. */
export function slotAt(at: Point, left: string, right: string): Slot | undefined {
  return iconAt(at, left) ?? betweenAt(at, left, right)
}

/** The slot between two icons. */
export function betweenAt(at: Point, left: string, right: string): Slot | undefined {
  const { x, y } = workspaceState.toPaper(at)
  const gap = gapAt(workspaceState.base.gaps, x, y, workspaceState.size)
  if (!gap) return undefined
  const edges = edgesAt(workspaceState.app, gap)
  const isFilled = gap.hole !== 0 && (edges?.right === right || gap.hole < 0)
  return {
    flow: gap.flow,
    after: gap.after,
    hole: isFilled ? gap.hole : 0,
    replaces: 0,
    why: edges?.left === left ? '' : misfit(gap),
  }
}

/** The icon whose picture lies there: what is dropped on it comes in its place. */
function iconAt(at: Point, left: string): Slot | undefined {
  const { x, y } = workspaceState.toPaper(at)
  const cell = cellAt(workspaceState.base.cells, x, y, workspaceState.size)
  const step = cell && workspaceState.step(cell.step)
  if (!cell || (step?.kind ?? 'icon') !== 'icon') return undefined
  const place = { flow: cell.flow, after: stepBefore(cell.flow, cell.step) }
  const edges = edgesAt(workspaceState.app, place)
  const doesFit = edges?.isHole === true || edges?.left === left // behind a hole nothing fits anyway
  return { ...place, hole: 0, replaces: cell.step, why: doesFit ? '' : misfit(place) }
}

/** The step before another one in its flow; 0: the start icon. */
export function stepBefore(flow: string, step: number): number {
  const steps = workspaceState.app?.flows?.[flow]?.steps ?? []
  return steps[steps.indexOf(step) - 1] ?? 0
}

/** Why something with another left edge may not stand behind a step. */
export function misfit({ flow, after }: Place): string {
  const edge = edgesAt(workspaceState.app, { flow, after })?.left ?? ''
  const kinds = Object.entries(desk.tree.types)
    .filter(([, type]) => type.left === edge && type.role === 'target')
    .map(([name, type]) => typeTitle(name, type.role))
  const what = kinds.length ? kinds.join(t('upper.or')) : t('upper.anAction')
  const before = workspaceState.step(after)
  return before ? t('upper.fitsNot', { name: nameOf(before), what }) : t('upper.fitsNotAtStart', { what })
}
