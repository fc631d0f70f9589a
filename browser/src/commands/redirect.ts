// Commands before a run: look at everything that could keep it from running; another robot for it.
import { command } from '../state/commands'
import { desk } from '../link/desk.svelte'
import { openDialog } from '../state/dialogs.svelte'
import { workspace } from '../state/workspace.svelte'
import { isGoing } from '../run/orders'
import { check } from '../redirect/check.svelte'
import { t } from '../texts/index.svelte'

const isResting = (): boolean => desk.tree.applications[workspace.app] !== undefined && !isGoing()

command({
  id: 'application.check',
  group: 'application',
  level: 'applications',
  title: () => t('check.run'),
  keys: ['Alt+K'],
  when: isResting,
  run: () => check.look(workspace.app),
  whileTyping: true,
})
command({
  id: 'application.redirect',
  group: 'application',
  level: 'applications',
  title: () => t('redirect.menu'),
  keys: ['Alt+I'],
  when: isResting,
  run: () => openDialog('redirect'),
})
