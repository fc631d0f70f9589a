// What the canvas shows besides the document: which part of it, what is lit, what is open on it.
import { tick } from 'svelte'
import { SvelteSet } from 'svelte/reactivity'
import type { DocumentView } from '../api.gen'
import { desk } from '../link/desk.svelte'
import type { Rect } from '../geom/rect'
import type { Guide } from '../geom/snap'
import { PLAIN, type View as Seen } from '../geom/viewport'
import { canvas } from '../state/canvas.svelte'
import { keep, kept } from '../state/kept'
import { isPages } from '../state/keyboard'
import type { Point } from '../act/refused.svelte'
import { frameOf, membersOf, PAD, TAB } from './groups'
import { Scene } from './scene.svelte'
import { View } from './view.svelte'

/** Something small that is open beside a place of the page. */
export type Opened =
  | { kind: '' }
  /** Find a task and place it; at once, with the corner where the pointer is. */
  | { kind: 'quick'; at: Point }
  | { kind: 'menu'; at: Point; over: Over }
  /** On which processing unit a task shall live. */
  | { kind: 'units'; at: Point; task: string; corner: [number, number] }
  /** What several tasks shall be called as one, and in which order they come; they may be one already, under a name. */
  | { kind: 'group'; at: Point; tasks: string[]; name: string }
  /** What is to be known of a variable. */
  | { kind: 'locus'; at: Point; svar: string }

/** What lies under a pointer. */
export type Over = { kind: 'task' | 'locus' | 'group'; name: string } | { kind: 'ground' }

const NOTHING: Opened = { kind: '' }

class CanvasState {
  scene: Scene = $state.raw(new Scene(''))
  readonly view = new View()
  /** The variable whose lines are lit. */
  lit = $state('')
  /** The one thing on the canvas that Tab comes to, as `task:pd`, `locus:Q_MEZ` or `group:arm`. */
  focus = $state('')
  marquee: Rect | undefined = $state.raw(undefined)
  guides: readonly Guide[] = $state.raw([])
  opened: Opened = $state.raw(NOTHING)
  /** The task that would be placed by Enter, while one is looked for. */
  quickTask = $state('')
  isConstantsShown = $state(kept('constants', false))
  /** Constants whose lines are shown although the others are not. */
  readonly openedConstants = new SvelteSet<string>()
  /** Whether the first page has been left behind for good. */
  hasBegun = $state(kept('begun', false))
  isPanning = $state(false)
  /** Whether something is under the pointer that moves with it. */
  isHolding = $state(false)
  /** Whether what is under the pointer may be let go beneath the canvas: then its lower edge draws no paper along. */
  isForBelow = false
  isSpaceDown = $state(false)
  /** Grows when places must be taken from the document again. */
  turn = $state(0)
  /** Where the pointer is over the canvas, in pixels of the page. */
  pointer: Point | undefined
  svg: SVGSVGElement | undefined
  /** The turn of the last wish that was granted. */
  wished = 0
  private readonly views = new Map<string, Seen>()

  get document(): DocumentView | undefined {
    return desk.tree.documents[canvas.doc]
  }

  /** Whether its tasks can be turned on and off. */
  get isLive(): boolean {
    return this.hasValues && !desk.live.review
  }

  /** Whether its variables have values: those of now, or of the recorded instant that is shown. */
  get hasValues(): boolean {
    return this.document?.connection === 'live'
  }

  get menuAt(): Point {
    return this.opened.kind === '' ? { x: 0, y: 0 } : this.opened.at
  }

  close(): void {
    this.opened = NOTHING
  }

  toggleConstants(): void {
    this.isConstantsShown = !this.isConstantsShown
    keep('constants', this.isConstantsShown)
  }

  begin(): void {
    this.hasBegun = true
    keep('begun', true)
  }

  /** Show another document, as it was seen last; false where it was not yet seen. */
  show(doc: string): boolean {
    const { view } = this
    if (this.scene.doc) this.views.set(this.scene.doc, view.seen)
    this.scene = new Scene(doc)
    this.close()
    this.lit = this.focus = ''
    this.openedConstants.clear()
    const before = this.views.get(doc)
    view.seen = before ?? PLAIN
    return before !== undefined
  }

  /** Bring the whole document into the middle, or these tasks of it. */
  fit(names?: Iterable<string>): void {
    const bounds = this.scene.bounds(names)
    if (bounds) this.view.fit(bounds)
    else this.view.seen = PLAIN
  }

  /** The rectangle of what a focus names. */
  rectOf(focus: string): Rect | undefined {
    const at = focus.indexOf(':')
    const name = focus.slice(at + 1)
    if (focus.startsWith('group:')) return this.tabOf(name)
    return focus.startsWith('task:') ? this.scene.boxes.get(name)?.rect : this.scene.dots.get(name)?.rect
  }

  /** About where the tab of a supermodule is. */
  private tabOf(group: string): Rect | undefined {
    const bounds = this.scene.bounds(membersOf(this.document, group))
    if (!bounds) return undefined
    const { x, y } = frameOf(bounds)
    return { x, y: y - TAB, w: Math.min(120, bounds.w), h: TAB }
  }

  /** A document that is seen for the first time: at full size where it fits, from its upper left corner where not. */
  open(): void {
    const bounds = this.scene.bounds()
    if (!bounds) return
    const { w, h } = this.view.size
    const above = Object.keys(this.document?.groups ?? {}).length ? PAD + TAB : 0
    const fits = bounds.x >= 0 && bounds.y >= above && bounds.x + bounds.w <= w && bounds.y + bounds.h <= h
    if (fits) this.view.seen = PLAIN
    else this.view.fit(bounds)
  }

  /** Bring something into view, and let Tab come to it. */
  turnTo(focus: string): void {
    const rect = this.rectOf(focus)
    if (!rect) return
    this.focus = focus
    this.view.bringIn(rect)
  }

  /** Give the keyboard to a box or a dot, and bring it into view. */
  focusOn(focus: string): void {
    this.turnTo(focus)
    // The box may only now come into view, and so into the page.
    void tick().then(() => this.element(focus)?.focus({ preventScroll: true }))
  }

  /** What takes the keyboard for a box or a dot. */
  element(focus: string): SVGElement | undefined {
    const at = focus.indexOf(':')
    const place = `[data-${focus.slice(0, at)}="${CSS.escape(focus.slice(at + 1))}"]`
    return this.svg?.querySelector<SVGElement>(`${place}[role=button], ${place} [role=button]`) ?? undefined
  }

  /** Whether the keyboard is with the canvas: with something on it, or with nothing at all. */
  get hasKeyboard(): boolean {
    return isPages() || (this.svg?.contains(document.activeElement) ?? false)
  }
}

export const canvasState = new CanvasState()
