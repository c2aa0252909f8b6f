// UPS for C#: how are the native libraries called here? The raw layer has their names on Linux, which Mono and .NET
// find by themselves: beside the program, in a NuGet package, on the system's paths. Of other systems, which were never
// tried, .NET learns the names here; the assembly for .NET Standard knows Linux alone.
#if NET8_0_OR_GREATER
using System;
using System.Reflection;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace Ups
{
    internal static class Loader
    {
#pragma warning disable CA2255  // nothing else runs before the first call, wherever that is
        [ModuleInitializer]
#pragma warning restore CA2255
        internal static void Register()
        {
            if (!OperatingSystem.IsLinux()) NativeLibrary.SetDllImportResolver(typeof(Loader).Assembly, Find);
        }

        private static IntPtr Find(string name, Assembly assembly, DllImportSearchPath? path)
        {
            IntPtr library;
            NativeLibrary.TryLoad(NameElsewhere(name, OperatingSystem.IsWindows()), assembly, path, out library);
            return library;
        }

        /// <summary>Of libups_gltf.so.0.1: ups_gltf.dll on Windows, libups_gltf.0.1.dylib on macOS.</summary>
        internal static string NameElsewhere(string name, bool windows)
        {
            var parts = name.Split(".so.");
            return windows ? parts[0].Substring("lib".Length) + ".dll" : parts[0] + "." + parts[1] + ".dylib";
        }
    }
}
#endif
