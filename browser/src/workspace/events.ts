// All that is heard in the workspace comes in here; there are no listeners on single icons.
import { look } from '../state/look.svelte'
import { workspace } from '../state/workspace.svelte'
import { workspaceState } from './workspaceState.svelte'
import { paste } from './acts'
import { PointerGestures, overOf } from './pointer'
import { keyDown } from './keys'

const REST_MS = 400
/** So far the pointer goes before what it rests on is told of again, after something was put down. */
const AWAY = 16

/** Hear everything from now on; the result ends it. */
export function listen(ground: HTMLElement, paper: SVGSVGElement): () => void {
  const hand = new PointerGestures()
  const ending = new AbortController()
  let moved = 0
  let rest: ReturnType<typeof setTimeout> | undefined
  const on = <K extends keyof HTMLElementEventMap>(
    target: EventTarget,
    name: K,
    listener: (event: HTMLElementEventMap[K]) => void,
    options: AddEventListenerOptions = {},
  ): void => target.addEventListener(name, listener as EventListener, { signal: ending.signal, ...options })

  /** What the pointer rests on is told of. */
  const hover = (event: PointerEvent): void => {
    clearTimeout(rest)
    const over = overOf(event.target)
    const step = over.kind === 'step' && !hand.isBusy ? over.step : 0
    if (workspaceState.hovered && workspaceState.hovered !== step) workspaceState.hovered = 0
    if (step && !workspaceState.isQuiet) rest = setTimeout(() => (workspaceState.hovered = step), REST_MS)
  }

  on(ground, 'pointerover', hover)
  on(ground, 'pointermove', (event) => {
    if (!workspaceState.isQuiet) return
    moved += Math.abs(event.movementX) + Math.abs(event.movementY)
    if (moved < AWAY) return
    workspaceState.isQuiet = false
    moved = 0
  })
  on(ground, 'pointerleave', () => {
    clearTimeout(rest)
    workspaceState.hovered = 0
  })
  on(ground, 'scroll', () => (workspaceState.top = ground.scrollTop), { passive: true })
  on(ground, 'wheel', wheel, { passive: false })
  const end = (): void => {
    clearTimeout(rest)
    ending.abort()
  }
  if (look.isFixed) return end // it is looked at, and that is all

  on(ground, 'pointerdown', (event) => {
    if (!isPaper(event)) return
    workspaceState.hovered = 0
    clearTimeout(rest)
    hand.down(event)
  })
  on(ground, 'mousedown', (event) => isPaper(event) && event.preventDefault()) // the middle button scrolls, the left one marks text
  on(ground, 'dblclick', (event) => isPaper(event) && hand.double(event))
  on(ground, 'contextmenu', (event) => isPaper(event) && hand.context(event))
  on(paper, 'focus', () => (workspaceState.hasKeys = true))
  on(paper, 'blur', () => (workspaceState.hasKeys = false))
  on(window as EventTarget, 'pointermove', (event) => hand.move(event))
  on(window as EventTarget, 'pointerup', (event) => hand.up(event))
  on(window as EventTarget, 'pointercancel', () => hand.cancel())
  on(window as EventTarget, 'blur', () => hand.cancel())
  // Before the commands of the page hear it: a gesture under way is what Esc means.
  on(
    window as EventTarget,
    'keydown',
    (event) => {
      workspaceState.hovered = 0
      if (event.key === 'Escape' && hand.isBusy) hand.cancel()
      else if (!keyDown(event)) return
      event.preventDefault()
      event.stopPropagation()
    },
    { capture: true },
  )
  on(document as EventTarget, 'paste', (event) => pasteText(event as ClipboardEvent))
  return end
}

/** Buttons that lie on the paper are no paper. */
const isPaper = ({ target }: Event): boolean =>
  target instanceof Element && target.closest('button, input, select, .float') === null

const SIZES = [32, 64, 96]

/** With Ctrl the wheel makes icons larger or smaller. */
function wheel(event: WheelEvent): void {
  if (!event.ctrlKey && !event.metaKey) return
  event.preventDefault()
  const at = SIZES.indexOf(workspaceState.size) - Math.sign(event.deltaY)
  workspaceState.resize(SIZES[Math.max(0, Math.min(SIZES.length - 1, at))]!)
}

function pasteText(event: ClipboardEvent): void {
  if (!workspaceState.hasKeyboard || !workspace.app || workspaceState.opened.kind !== '') return
  event.preventDefault()
  void paste(event.clipboardData?.getData('text/plain') ?? '')
}
