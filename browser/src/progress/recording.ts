// A run that is recorded, or done again in a simulator.
import type { RuntimeView } from '../api.gen'
import { t } from '../texts/index.svelte'

/** The name of a file without its folders. */
export const fileOf = (path: string): string => path.split('/').at(-1) ?? path

/** Whether the runtime is the simulator in which a recorded run was gone on from; its time passes as ours does. */
export const isSimulator = (runtime: RuntimeView): boolean => runtime.is_virtual === true && !runtime.address

/** What starting the runtime anew means, as a button and in full. */
export const anewWords = (runtime: RuntimeView): { name: string; hint: string } =>
  isSimulator(runtime)
    ? { name: t('recording.leave'), hint: t('recording.leaveHint') }
    : { name: t('perform.putBack'), hint: t('perform.putBackHint') }
