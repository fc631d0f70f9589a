// Files by the base directory they lie in, those that fit what was typed.

interface Filed {
  name: string
  base: string
}

export function shelves<File extends Filed>(files: readonly File[], words: string): [string, File[]][] {
  const wanted = words.trim().toLowerCase()
  const bases = new Map<string, File[]>()
  const fits = files.filter((file) => `${file.name} ${file.base}`.toLowerCase().includes(wanted))
  for (const file of fits.sort((a, b) => a.name.localeCompare(b.name)))
    bases.set(file.base, [...(bases.get(file.base) ?? []), file])
  return [...bases].sort(([a], [b]) => a.localeCompare(b))
}
