// The stations of the environment: runtimes with which it is connected, each by its name; that of the first is empty.
import type { RunView, RuntimeView } from '../api.gen'
import { workspace } from '../state/workspace.svelte'
import type { FullTree } from './desk.svelte'

export type Station = [name: string, runtime: RuntimeView]

export const stationsIn = (tree: FullTree): Station[] => [['', tree.runtime], ...Object.entries(tree.stations)]

export const runtimeAt = (tree: FullTree, station = ''): RuntimeView =>
  station ? (tree.stations[station] ?? {}) : tree.runtime

/** All worlds that are open, as they are named beside each other: `boxes`, at another station `cmu/boxes`. */
export const worldsIn = (tree: FullTree): string[] =>
  stationsIn(tree).flatMap(([station, runtime]) =>
    Object.keys(runtime.worlds ?? {}).map((world) => (station ? `${station}/${world}` : world)),
  )

/** The station of a world that is so named, and its name there. */
export function worldAt(name: string): [station: string, world: string] {
  const at = name.lastIndexOf('/')
  return at < 0 ? ['', name] : [name.slice(0, at), name.slice(at + 1)]
}

/** Of these worlds the one to look at: the one that was picked, else the first that a program drives, else the first. */
export function worldFor(worlds: readonly string[], picked: string, driven: readonly string[]): string {
  if (worlds.includes(picked)) return picked
  return worlds.find((name) => driven.includes(worldAt(name)[1])) ?? worlds[0] ?? ''
}

/** The stations at which all is stopped. */
export const stoppedIn = (tree: FullTree): Station[] =>
  stationsIn(tree).filter(([, runtime]) => runtime.is_stopped === true)

/** The station at which all flows of an application are carried out, else the first one; of the one shown where none is named. */
export function stationFor(tree: FullTree, doc = workspace.app): string {
  const placed = Object.values(tree.applications[doc]?.stations ?? {})
  return new Set(placed).size === 1 ? placed[0]! : ''
}

/** The runtime there. */
export const runtimeFor = (tree: FullTree, doc = workspace.app): RuntimeView => runtimeAt(tree, stationFor(tree, doc))

/** Where a flow of a run is carried out. */
export const stationIn = (run: RunView, subsystem: string): string =>
  run.flows?.[subsystem]?.station || (run.station ?? '')
