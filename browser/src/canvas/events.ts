// All that is heard on the canvas comes in here; there are no listeners on single boxes.
import { wheelFactor } from '../geom/viewport'
import { canvas } from '../state/canvas.svelte'
import { paste } from '../scene/acts'
import { Edge } from './edge'
import { PointerGestures } from './pointer'
import { keyDown, keyUp } from './keys'
import { canvasState } from '../scene/canvasState.svelte'

/** Hear everything from now on; the result ends it. */
export function listen(ground: HTMLElement, svg: SVGSVGElement, measure: () => void): () => void {
  const hand = new PointerGestures()
  const edge = new Edge()
  const ending = new AbortController()
  const on = <K extends keyof HTMLElementEventMap>(
    target: EventTarget,
    name: K,
    listener: (event: HTMLElementEventMap[K]) => void,
    options: AddEventListenerOptions = {},
  ): void => target.addEventListener(name, listener as EventListener, { signal: ending.signal, ...options })

  on(svg, 'pointerdown', (event) => {
    measure()
    hand.down(event)
  })
  on(svg, 'mousedown', (event) => event.button === 1 && event.preventDefault()) // or the browser scrolls by itself
  on(svg, 'dblclick', (event) => hand.double(event))
  on(svg, 'contextmenu', (event) => hand.context(event))
  // The first page lies over the paper, and is paper where there is nothing to press.
  on(ground, 'dblclick', (event) => isPage(event) && hand.double(event))
  on(ground, 'contextmenu', (event) => isPage(event) && hand.context(event))
  on(svg, 'pointerover', (event) => light(event.target))
  on(svg, 'pointerleave', () => light(null))
  on(ground, 'pointermove', (event) => (canvasState.pointer = { x: event.clientX, y: event.clientY }))
  on(ground, 'pointerleave', () => (canvasState.pointer = undefined))
  on(ground, 'wheel', wheel, { passive: false })
  on(window as EventTarget, 'pointermove', (event) => {
    hand.move(event)
    if (hand.isBusy) edge.follow(event, (same) => hand.move(same))
  })
  on(window as EventTarget, 'pointerup', (event) => {
    edge.stop()
    hand.up(event)
  })
  on(window as EventTarget, 'pointercancel', () => hand.cancel())
  on(window as EventTarget, 'blur', () => {
    hand.cancel()
    canvasState.isSpaceDown = false
  })
  // Before the commands of the page hear it: a gesture under way is what Esc means.
  on(
    window as EventTarget,
    'keydown',
    (event) => {
      if (event.key === 'Escape' && hand.isBusy) hand.cancel()
      else if (!keyDown(event)) return
      event.preventDefault()
      event.stopPropagation()
    },
    { capture: true },
  )
  on(window as EventTarget, 'keyup', keyUp)
  on(document as EventTarget, 'paste', (event) => pasteText(event as ClipboardEvent))
  on(ground, 'dragover', (event) => event.preventDefault())
  on(ground, 'drop', (event) => void drop(event))
  return () => {
    edge.stop()
    ending.abort()
  }
}

const isPage = ({ target }: Event): boolean =>
  target instanceof Element && target.closest('.first') !== null && !target.closest('button')

function light(target: EventTarget | null): void {
  const element = target instanceof Element ? target.closest<SVGElement>('[data-locus], [data-net]') : null
  canvasState.lit = element?.dataset.locus ?? element?.dataset.net ?? ''
}

function wheel(event: WheelEvent): void {
  if (event.target instanceof Element && event.target.closest('[role=listbox], .first')) return
  event.preventDefault()
  const unit = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1
  if (event.ctrlKey || event.metaKey)
    canvasState.view.zoom(wheelFactor(event.deltaY * unit), event.clientX, event.clientY)
  else if (event.shiftKey && !event.deltaX) canvasState.view.pan(-event.deltaY * unit, 0)
  else canvasState.view.pan(-event.deltaX * unit, -event.deltaY * unit)
}

function pasteText(event: ClipboardEvent): void {
  if (!canvasState.hasKeyboard || !canvas.doc) return
  event.preventDefault()
  void paste(event.clipboardData?.getData('text/plain') ?? '')
}

/** A configuration's file that is dropped is placed as text that was pasted there. */
async function drop(event: DragEvent): Promise<void> {
  event.preventDefault()
  canvasState.pointer = { x: event.clientX, y: event.clientY }
  const file = event.dataTransfer?.files[0]
  const text = file ? await file.text() : (event.dataTransfer?.getData('text/plain') ?? '')
  if (text) await paste(text)
}
