// Configurations by the base directory they lie in, those that fit what was typed.
import type { ConfigurationFile } from '../api.gen'

export function shelves(files: readonly ConfigurationFile[], words: string): [string, ConfigurationFile[]][] {
  const wanted = words.trim().toLowerCase()
  const bases = new Map<string, ConfigurationFile[]>()
  const fits = files.filter((file) => `${file.name} ${file.base}`.toLowerCase().includes(wanted))
  for (const file of fits.sort((a, b) => a.name.localeCompare(b.name))) bases.set(file.base, [...(bases.get(file.base) ?? []), file])
  return [...bases].sort(([a], [b]) => a.localeCompare(b))
}
