// What the workspace shows besides the application: how large, which part, what is open on it, what is on its way.
import type { ApplicationView, StepView } from '../api.gen'
import { desk } from '../link/desk.svelte'
import { look } from '../state/look.svelte'
import { workspace, type Place } from '../state/workspace.svelte'
import { keep, kept } from '../state/kept'
import { isPages, keeperOf } from '../state/keyboard'
import type { Point } from '../act/refused.svelte'
import { actionsOf, loopsOf, topsOf, type Actions, type Loop } from '../application/actions'
import { arrange, type Arrangement, type Cell, type Content, type Gap } from '../application/arrangement'
import { gapOf } from '../application/gaps'

/** Something small that is open beside a place of the page. */
export type Opened =
  | { kind: '' }
  /** Find an icon and insert it, or put it in the place of a step; `words` is what was typed already. */
  | { kind: 'quick'; words: string; replaces?: number }
  | { kind: 'menu'; at: Point; over: Over }
  /** The tag at which an action waits for other flows. */
  | { kind: 'tag'; step: number }
  /** Steps that are to be done so many times. */
  | { kind: 'repeat'; steps: readonly number[] }
  /** A loop between two actions; without an anchor, the other end is still to be pointed at. */
  | { kind: 'loop'; step: number; other: number }
  | { kind: 'condition'; step: number }
  /** The flows of a branch, and when each runs; 0: one that is to be inserted. */
  | { kind: 'branch'; step: number }
  /** Name and types. */
  | { kind: 'facts'; step: number }

/** What lies under a pointer: a step, the name of a flow, or nothing. */
export type Over = { kind: 'step'; step: number } | { kind: 'flow'; flow: string } | { kind: 'ground' }

/** Where what is carried would go, and why it would not. */
export interface Slot extends Place {
  readonly hole: number
  /** The icon in whose place it would come; 0: between icons. */
  readonly replaces: number
  readonly why: string
}

/** Steps under way to another place. */
export interface Lifted {
  readonly steps: readonly number[]
  readonly at: Point
  readonly isCopy: boolean
  /** Whether they would be deleted here, outside of the workspace. */
  readonly isOutside: boolean
}

export interface Area {
  x: number
  y: number
  w: number
  h: number
}

const NOTHING: Opened = { kind: '' }
const NO_APP: ApplicationView = { name: '', order: 0 }
/** The seen part counts in steps of this, so that a little scrolling draws nothing new. */
const STRIDE = 120
export const SIZES = [32, 64, 96] as const

class WorkspaceState {
  size = $state(kept<number>('onikons', 64))
  isLettered = $state(kept('letters', false))
  width = $state(800)
  top = $state(0)
  height = $state(600)
  opened: Opened = $state.raw(NOTHING)
  slot: Slot | undefined = $state.raw(undefined)
  lifted: Lifted | undefined = $state.raw(undefined)
  marquee: Area | undefined = $state.raw(undefined)
  /** The step under the pointer, and whether it has been there for a while. */
  hovered = $state(0)
  hasKeys = $state(false)
  /** Something was just dropped: until the pointer moves on, nothing is told of what lies under it. */
  isQuiet = false
  /** What scrolls. */
  ground: HTMLElement | undefined
  paper: SVGSVGElement | undefined

  readonly actions: Actions = $derived(actionsOf(this.app ?? NO_APP))
  readonly loops: readonly Loop[] = $derived(loopsOf(this.app ?? NO_APP))
  private readonly content: Content = $derived(contentOf(this.app ?? NO_APP))
  private readonly frame = $derived({
    width: this.width,
    size: this.size,
    extra: 11 * Math.max(0, ...this.loops.map((loop) => loop.depth)),
  })
  /** As it is: what a pointer means is found in this one. */
  readonly base: Arrangement = $derived(arrange(this.content, this.frame))
  /** As it is drawn: with the place open for what is carried. */
  readonly shown: Arrangement = $derived(
    this.slot && !this.slot.hole && !this.slot.replaces && !this.slot.why
      ? arrange(this.content, this.frame, this.slot)
      : this.base,
  )
  readonly cells: ReadonlyMap<number, Cell> = $derived(
    new Map(this.shown.cells.filter((cell) => cell.step > 0).map((cell) => [cell.step, cell])),
  )
  /** The rows that are near what is seen. */
  private readonly first = $derived(Math.floor(this.top / STRIDE) * STRIDE - STRIDE)
  private readonly last = $derived(Math.ceil((this.top + this.height) / STRIDE) * STRIDE + STRIDE)
  readonly visible: readonly Cell[] = $derived(within(this.shown.cells, this.first - this.size, this.last))
  readonly caret: Gap | undefined = $derived(gapOf(this.shown.gaps, workspace.place))

  get app(): ApplicationView | undefined {
    return desk.tree.applications[workspace.app]
  }

  step(number: number): StepView | undefined {
    return this.app?.steps?.[number]
  }

  /** Whether a row at this height is near what is seen. */
  isNear(y: number, height: number = this.size): boolean {
    return y + height > this.first && y < this.last
  }

  get isRunning(): boolean {
    return this.app?.is_running === true
  }

  /** Whether what is typed is meant for the workspace. */
  get hasKeyboard(): boolean {
    const at = document.activeElement
    return (
      this.app !== undefined &&
      look.level === 'applications' &&
      (isPages() || ((this.ground?.contains(at) ?? false) && !keeperOf(at)))
    )
  }

  close(): void {
    this.opened = NOTHING
  }

  resize(size: number): void {
    this.size = size
    keep('onikons', size)
  }

  turnLetters(): void {
    this.isLettered = !this.isLettered
    keep('letters', this.isLettered)
  }

  /** From pixels of the window to those of the paper. */
  toPaper({ x, y }: Point): Point {
    const { left = 0, top = 0 } = this.paper?.getBoundingClientRect() ?? {}
    return { x: x - left, y: y - top }
  }

  toWindow({ x, y }: Point): Point {
    const { left = 0, top = 0 } = this.paper?.getBoundingClientRect() ?? {}
    return { x: x + left, y: y + top }
  }

  /** Whether a place of the window lies beside the workspace; beyond the window nobody knows. */
  isOutside({ x, y }: Point): boolean {
    if (!this.ground || x < 0 || y < 0 || x >= window.innerWidth || y >= window.innerHeight) return false
    const { left, right, top, bottom } = this.ground.getBoundingClientRect()
    return x < left || x >= right || y < top || y >= bottom
  }

  /** Scroll so that a row is seen. */
  show(y: number): void {
    const { ground, size, top, height } = this // as they were measured: asking the page would make it lay itself out
    if (!ground) return
    const [above, below] = [Math.max(0, y - 48), y + size + 48]
    if (above >= top && below <= top + height) return
    ground.scrollTop = above < top ? above : below - height
    this.top = ground.scrollTop
  }

  focus(): void {
    this.paper?.focus({ preventScroll: true })
  }
}

/** Those of many between two heights. */
const within = (cells: readonly Cell[], first: number, last: number): Cell[] =>
  cells.filter(({ y }) => y > first && y < last)

function contentOf(app: ApplicationView): Content {
  const { flows = {}, steps = {} } = app
  return {
    tops: topsOf(app),
    steps: (path) => flows[path]?.steps ?? [],
    step: (number) => {
      const step = steps[number]
      return { joined: step?.is_joined === true, isHole: step?.kind === 'hole', flows: step?.flows ?? [] }
    },
  }
}

export const workspaceState = new WorkspaceState()
