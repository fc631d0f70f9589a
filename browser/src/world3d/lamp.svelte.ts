// Whether the lamps of the simulated workcell shine, where a workcell tells it.
import { desk } from '../link/desk.svelte'
import { worldsIn } from '../link/stations'
import { onFrame, poses, watchWorld } from '../values/frames'
import { send } from '../link/link'
import { hasLamp, isLit, worldOf } from '../values/world'

/** Watch the workcells while whoever calls it is shown; call it where effects may be made. */
export function lamp(): { readonly isLit: boolean | undefined } {
  let lit: boolean | undefined = $state()
  const worlds = $derived(worldsIn(desk.tree).join('\n'))
  $effect(() => {
    const names = worlds ? worlds.split('\n') : []
    const lamps = new Set<string>()
    const look = (): void => {
      const answers = names
        .filter((name) => lamps.has(name))
        .map((name) => isLit(poses(name)))
        .filter((answer) => answer !== undefined)
      lit = answers.length ? answers.some(Boolean) : undefined
    }
    const ends = [...names.map((name) => watchWorld(name)), onFrame(look)]
    // A workcell without a lamp says nothing of one.
    for (const name of names)
      void send({ t: 'Scene', world: name })
        .then((answer) => hasLamp(worldOf(answer)) && void (lamps.add(name), look()))
        .catch(() => undefined)
    return () => ends.forEach((end) => end())
  })
  return {
    get isLit() {
      return lit
    },
  }
}
