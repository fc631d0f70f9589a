// A hand presses what may be touched in a simulated workcell, and lets it go.
import { act } from '../act/act'
import { desk } from '../link/desk.svelte'
import { runtimeAt, worldAt } from '../link/stations'

/** What of a world is pressed. */
export function pressedIn(world: string): readonly string[] {
  const [station, name] = worldAt(world)
  return runtimeAt(desk.tree, station)?.pressed?.[name] ?? []
}

/** One more press lets go; what is refused is said where the pointer was. */
export function touch(event: MouseEvent, world: string, part: string): void {
  const at = event.detail ? { x: event.clientX, y: event.clientY } : undefined
  void act({ t: 'Touch', world, part, is_pressed: !pressedIn(world).includes(part) }, at)
}
