// How many inputs nobody supplies, Equation (6): the environment says who writes a variable, here it is only counted.
import type { DocumentView } from '../api.gen'
import { isInput } from './pin'
import type { Scene } from './scene.svelte'

export function hanging(scene: Pick<Scene, 'boxes'>, document: DocumentView | undefined): number {
  let count = 0
  for (const box of scene.boxes.values())
    for (const pin of box.pins) if (isInput(pin) && !document?.loci?.[pin.svar]?.writers?.length) count += 1
  return count
}
