// Icons dragged within the workspace: they move, or with Ctrl their copies do; outside of it they are deleted.
import type { Gesture } from '../gesture/gesture'
import { workspace } from '../state/workspace.svelte'
import { showRefusal } from '../act/refused.svelte'
import { Refusal } from '../link/refusal'
import { t } from '../texts/index.svelte'
import { workspaceState, type Slot } from './workspaceState.svelte'
import { copyTo, move, noteSteps, remove } from './acts'
import { edgeScroll } from './scrolling'
import { betweenAt, slotAt } from './slot'
import { plain } from '../texts/say'

export class Dragging implements Gesture {
  constructor(
    private readonly steps: readonly number[],
    first: PointerEvent,
  ) {
    this.move(first)
  }

  move(event: PointerEvent): void {
    const at = { x: event.clientX, y: event.clientY }
    const isCopy = event.ctrlKey || event.metaKey
    const [first, last] = [workspaceState.step(this.steps[0] ?? 0), workspaceState.step(this.steps.at(-1) ?? 0)]
    const slot = (isCopy ? betweenAt : slotAt)(at, first?.left ?? '', last?.right ?? '')
    const isOutside = !slot && !isCopy && workspaceState.isOutside(at)
    workspaceState.lifted = { steps: this.steps, at, isCopy, isOutside }
    workspaceState.slot = slot && !this.isOwn(slot) ? slot : undefined
    edgeScroll(event)
  }

  up(event: PointerEvent): void {
    const { slot, lifted } = workspaceState
    const isCopy = event.ctrlKey || event.metaKey
    this.putDown()
    if (slot || lifted?.isOutside) noteSteps('end_drag', this.steps)
    if (!slot && lifted?.isOutside && !workspaceState.isRunning) return void remove([...this.steps])
    if (!slot) return noteSteps('cancel_drag', this.steps)
    workspaceState.isQuiet = true
    const at = { x: event.clientX, y: event.clientY }
    if (workspaceState.isRunning) showRefusal(new Refusal(plain(t('upper.locked'))), at)
    else if (isCopy) void copyTo(this.steps, slot, at)
    else void move(this.steps, slot, at)
  }

  cancel(): void {
    noteSteps('cancel_drag', this.steps)
    this.putDown()
  }

  private putDown(): void {
    workspaceState.lifted = undefined
    workspaceState.slot = undefined
  }

  /** Where it stands already. */
  private isOwn({ flow, after, replaces }: Slot): boolean {
    if (replaces) return this.steps.includes(replaces)
    if (workspaceState.lifted?.isCopy) return false
    const all = workspaceState.app?.flows?.[flow]?.steps ?? []
    const before = all[all.indexOf(this.steps[0] ?? 0) - 1] ?? 0
    return this.steps.includes(after) || (after === before && workspace.app !== '' && all.includes(this.steps[0] ?? 0))
  }
}
