// The middle button opens panels here; where a system pastes with it, it must not paste into the panel it has just opened.

/** Hear the middle button from now on; the result ends it. In a text field that was there before, it pastes as everywhere. */
export function tameMiddle(page: Window = window): () => void {
  const ending = new AbortController()
  const heed = { capture: true, signal: ending.signal }
  let isOurs = false
  const isText = (target: EventTarget | null): boolean =>
    target instanceof Element && target.closest('input, textarea, [contenteditable=true]') !== null
  page.addEventListener('pointerdown', (event) => (isOurs = event.button === 1 && !isText(event.target)), heed)
  page.addEventListener('keydown', () => (isOurs = false), heed)
  for (const name of ['mouseup', 'auxclick', 'paste'] as const)
    page.addEventListener(
      name,
      (event) => {
        if (!isOurs || ('button' in event && event.button !== 1)) return
        event.preventDefault()
        if (name === 'paste') event.stopPropagation()
      },
      heed,
    )
  return () => ending.abort()
}
