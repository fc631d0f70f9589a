// Colours of the look as a canvas needs them: in plain numbers, for the ground that is shown now.

/** What the look calls by these names, at this place of the page. */
export function inks<Name extends string>(place: Element, names: readonly Name[]): Record<Name, string> {
  const probe = document.createElement('i')
  probe.hidden = true
  place.append(probe)
  const inks = names.map((name) => {
    probe.style.color = `var(${name})`
    return [name, getComputedStyle(probe).color]
  })
  probe.remove()
  return Object.fromEntries(inks) as Record<Name, string>
}

/** Calls when the ground changes from light to dark or back; the result ends it. */
export function onGround(changed: () => void): () => void {
  const system = matchMedia('(prefers-color-scheme: dark)')
  const forced = new MutationObserver(changed)
  system.addEventListener('change', changed)
  forced.observe(document.documentElement, { attributes: true, attributeFilter: ['class', 'style', 'data-theme'] })
  return () => {
    system.removeEventListener('change', changed)
    forced.disconnect()
  }
}

/** Hue and dash of an element's line: both together, so that neither is needed alone. */
export const HUES = ['--p1', '--p2', '--p3', '--p4', '--p5', '--p6'] as const
const DASHES = [[], [7, 3], [2, 3], [9, 3, 2, 3], [4, 2], [12, 4]]
export const hue = (element: number): (typeof HUES)[number] => HUES[element % HUES.length]
/** After six elements the hues come again, with other dashes. */
export const dash = (element: number): number[] => DASHES[(element + Math.floor(element / HUES.length)) % DASHES.length]
