// What stands for an environment in a shared file: it shows one recorded run, and refuses all else.
import type { AnyAct, AnyMessage } from '../api.gen'
import type { Carrier } from '../link/link'
import { t } from '../texts/index.svelte'
import { plain } from '../texts/say'
import type { Film } from './film'

/** What only says who looks at what: nobody keeps it here. */
const QUIET: ReadonlySet<string> = new Set(['Note', 'Watch'])

export function carrierOf(film: Film): Carrier {
  const carrier: Carrier = {
    onopen: null,
    onclose: null,
    onmessage: null,
    send: (text) => {
      const { cid, act } = JSON.parse(text) as { cid: number; act: AnyAct }
      queueMicrotask(() => tell(answer(film, act, cid)))
    },
    close: () => undefined,
  }
  const tell = (message: AnyMessage): void => {
    carrier.onmessage?.({ data: JSON.stringify(message) })
  }
  setTimeout(() => tell({ t: 'Snapshot', rev: 0, tree: film.head.tree, version: film.head.version, you: '' }))
  return carrier
}

function answer(film: Film, act: AnyAct, cid: number): AnyMessage {
  const value = valueOf(film, act)
  if (value !== undefined) return { t: 'Ok', cid, rev: 0, value }
  return { t: 'Refused', cid, reason: plain(t('player.onlyLooks')) }
}

function valueOf(film: Film, act: AnyAct): unknown {
  switch (act.t) {
    case 'Glance':
      return film.instant(act.at_s)
    case 'Course':
      return film.course(act.variable, act.begin_s, act.end_s, act.points)
    case 'RecordedScene':
      return film.scene(act.world)
    case 'Meshes':
      return (act.meshes ?? []).filter((name) => film.mesh(name) !== undefined)
    default:
      return QUIET.has(act.t) ? null : undefined
  }
}
