// The pose becomes a target: what is measured now is asked for and written into the user's own dictionary (K07).
import type { TaughtView } from '../api.gen'
import { desk } from '../link/desk.svelte'
import { send } from '../link/link'
import { Refusal } from '../link/refusal'
import { initialsOf, lettered } from '../onikon/initials'
import { workspace } from '../state/workspace.svelte'

/** How long a motion to a taught target takes until somebody says otherwise, in s. */
const DURATION = '2.0'
const POSE = 'Cartesian object'
const JOINTS = 'Joint object'

/** The kinds of targets that a pose can become, as they are known here. */
export const poseKinds = (): readonly string[] => [POSE, JOINTS].filter((kind) => desk.tree.types[kind])
export const isOfJoints = (kind: string): boolean => kind === JOINTS

/** `taught_1`, or the next one that nobody has. */
export function freeName(): string {
  let number = 1
  while (desk.tree.onikons[`taught_${number}`]) number += 1
  return `taught_${number}`
}

/** Make a target of the pose; why not, or nothing. */
export async function keepPose(name: string, type: string): Promise<string> {
  try {
    const doc = desk.tree.run?.doc ?? workspace.app
    const taught = (await send({ t: 'Teach', type, doc })) as TaughtView
    const items = desk.tree.types[type]?.items ?? []
    const values = items.map((item) => taught.values[item.name]?.map(String) ?? [DURATION])
    const picture = lettered(initialsOf(name.replace('_', ' ')))
    await send({ t: 'MakeTarget', name, type, values, picture, arm: taught.made_for ?? '' })
    return ''
  } catch (why) {
    if (!(why instanceof Refusal)) throw why
    return why.reason
  }
}
