// Panels are shaped as the preferences say when a page begins; as somebody shapes them, they become preferences.
import { untrack } from 'svelte'
import { desk } from '../link/desk.svelte'
import { send } from '../link/link'
import { look } from '../state/look.svelte'
import { placesOf, type Places, sizesOf, standsOf, upperSizesOf } from './windowPlaces'

/** Narrower pages show one panel at a time: their sizes are nobody's choice. */
const LEAST_WIDTH = 900
const SETTLED_MS = 500

/** Do so from now on. Call it once, inside an effect root. */
export function keepPlaces(): void {
  let isShaped = false
  let before = shape()
  $effect(() => {
    if (desk.rev < 0 || isShaped) return
    isShaped = true
    untrack(shapePanels)
    before = untrack(shape)
  })
  $effect(() => {
    const now = shape()
    if (now === before || window.innerWidth < LEAST_WIDTH) return
    const timer = setTimeout(() => {
      before = now
      void send({
        t: 'Prefer',
        values: { places: placesOf(extent(), look.sizes, look.upperSizes, look.stands) },
      }).catch(
        () => undefined, // where nothing may be changed nothing is kept
      )
    }, SETTLED_MS)
    return () => clearTimeout(timer)
  })
}

const shape = (): string => JSON.stringify([look.sizes, look.upperSizes, look.stands])

const extent = (): { width: number; height: number } => ({ width: window.innerWidth, height: window.innerHeight })

function shapePanels(): void {
  const places = desk.tree.preferences.places as Places | undefined
  if (!places || window.innerWidth < LEAST_WIDTH) return
  look.sizes = sizesOf(places, extent(), look.sizes)
  look.upperSizes = upperSizesOf(places, extent(), look.upperSizes)
  look.stands = standsOf(places, look.stands)
}
